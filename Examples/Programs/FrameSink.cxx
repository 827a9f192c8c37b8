// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FrameSink.h"

#include "OutputFolder.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOggTheoraWriter.h>
#include <vtkPNGWriter.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace hachure::program
{
namespace
{
/// Frames that wait for the writer; more would only hold memory.
constexpr std::size_t LongestQueue = 3;
/// Of zlib, 0 to 9: line drawings shrink little more above this, and cost three times as much.
constexpr int PngCompression = 3;
/// Of a picture in the contact sheet.
constexpr int ThumbnailWidth = 320;
/// Of VTK's writer, 0 to 2.
constexpr int MovieQuality = 2;
const char* const MovieName = "movie.ogv";
const char* const ContactName = "contact.png";

vtkSmartPointer<vtkImageData> toImage(const Picture& picture)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(picture.width, picture.height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::memcpy(image->GetScalarPointer(), picture.pixels.data(), picture.pixels.size());
  return image;
}

std::string frameName(int index)
{
  char name[32];
  std::snprintf(name, sizeof(name), "frame_%04d.png", index);
  return name;
}
} // namespace

//----------------------------------------------------------------------------
FrameSink::FrameSink(const FrameSinkOptions& given)
  : options(given)
  , contact(contactFrames(given.frames))
{
  this->madeFolder = makeWritableFolder(this->options.folder);
  this->worker = std::thread([this] { this->work(); });
}

//----------------------------------------------------------------------------
FrameSink::~FrameSink()
{
  this->stop();
  this->movie = nullptr;
  std::error_code ignored;
  std::filesystem::remove(this->temporary(MovieName), ignored);
  std::filesystem::remove(this->temporary(ContactName), ignored);
  std::filesystem::remove(this->temporary(frameName(this->written)), ignored);
  if (this->madeFolder)
  {
    std::filesystem::remove(this->options.folder, ignored); // only succeeds when it is empty
  }
}

//----------------------------------------------------------------------------
std::filesystem::path FrameSink::temporary(const std::string& name) const
{
  return this->options.folder / ("." + name + ".part");
}

//----------------------------------------------------------------------------
void FrameSink::publish(const std::string& name)
{
  std::filesystem::rename(this->temporary(name), this->options.folder / name);
}

//----------------------------------------------------------------------------
void FrameSink::add(Picture&& frame)
{
  std::unique_lock<std::mutex> lock(this->guard);
  this->changed.wait(lock, [this] { return this->failure || this->queue.size() < LongestQueue; });
  if (this->failure)
  {
    std::rethrow_exception(this->failure);
  }
  this->queue.push_back(std::move(frame));
  this->changed.notify_all();
}

//----------------------------------------------------------------------------
void FrameSink::stop()
{
  {
    const std::lock_guard<std::mutex> lock(this->guard);
    this->closed = true;
  }
  this->changed.notify_all();
  if (this->worker.joinable())
  {
    this->worker.join();
  }
}

//----------------------------------------------------------------------------
void FrameSink::finish()
{
  this->stop();
  if (this->failure)
  {
    std::rethrow_exception(this->failure);
  }
  if (this->movie)
  {
    this->movie->End();
    this->publish(MovieName);
  }
  if (!this->thumbnails.empty())
  {
    this->writePicture(contactSheet(this->thumbnails), ContactName);
  }
}

//----------------------------------------------------------------------------
void FrameSink::work()
{
  std::unique_lock<std::mutex> lock(this->guard);
  while (true)
  {
    this->changed.wait(lock, [this] { return this->closed || !this->queue.empty(); });
    if (this->queue.empty())
    {
      return;
    }
    const Picture frame = std::move(this->queue.front());
    this->queue.pop_front();
    this->changed.notify_all();
    lock.unlock();
    try
    {
      this->writeFrame(frame);
      lock.lock();
    }
    catch (...)
    {
      lock.lock();
      this->failure = std::current_exception();
      this->changed.notify_all();
      return;
    }
  }
}

//----------------------------------------------------------------------------
void FrameSink::writeFrame(const Picture& rendered)
{
  const Picture frame = averagedDown(rendered, this->options.width, this->options.height);
  this->writePicture(frame, frameName(this->written));
  this->keepForContact(frame);
  if (this->options.movie)
  {
    this->appendToMovie(frame);
  }
  ++this->written;
}

//----------------------------------------------------------------------------
void FrameSink::writePicture(const Picture& picture, const std::string& name)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(toImage(picture));
  writer->SetFileName(this->temporary(name).c_str());
  writer->SetCompressionLevel(PngCompression);
  writer->Write();
  if (writer->GetErrorCode() != 0)
  {
    throw std::runtime_error("cannot write " + (this->options.folder / name).string());
  }
  this->publish(name);
}

//----------------------------------------------------------------------------
void FrameSink::keepForContact(const Picture& picture)
{
  if (std::find(this->contact.begin(), this->contact.end(), this->written) == this->contact.end())
  {
    return;
  }
  const int width = std::min(picture.width, ThumbnailWidth);
  const int height = std::max(1, static_cast<int>(1.0 * picture.height * width / picture.width));
  this->thumbnails.push_back(averagedDown(picture, width, height));
}

//----------------------------------------------------------------------------
void FrameSink::appendToMovie(const Picture& picture)
{
  const auto image = toImage(picture);
  const bool starting = !this->movie;
  if (starting)
  {
    this->movie = vtkSmartPointer<vtkOggTheoraWriter>::New();
    this->movie->SetFileName(this->temporary(MovieName).c_str());
    this->movie->SetRate(this->options.frameRate);
    this->movie->SetQuality(MovieQuality);
  }
  this->movie->SetInputData(image);
  if (starting)
  {
    this->movie->Start();
  }
  this->movie->Write();
  if (this->movie->GetError() != 0)
  {
    throw std::runtime_error("cannot write " + (this->options.folder / MovieName).string());
  }
}
} // namespace hachure::program
