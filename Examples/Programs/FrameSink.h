// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// Takes rendered pictures and writes frames, movie and contact sheet beside the drawing.

#ifndef FrameSink_h
#define FrameSink_h

#include "LinearImage.h"

#include <vtkSmartPointer.h>

#include <condition_variable>
#include <deque>
#include <exception>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

class vtkOggTheoraWriter;

namespace hachure::program
{
struct FrameSinkOptions
{
  std::filesystem::path folder;
  int width = 0; ///< of the written pictures; what comes in may be larger
  int height = 0;
  int frames = 1; ///< how many will come
  bool movie = false;
  int frameRate = 24; ///< of the movie, per second
};

/// Every file is written under a temporary name and renamed when it is complete. Temporary files,
/// and the folder when it was made here and stayed empty, go with an object that was not finished.
class FrameSink
{
public:
  /// Makes the folder. Throws UserError when that or writing there is not possible.
  explicit FrameSink(const FrameSinkOptions& options);
  ~FrameSink();
  FrameSink(const FrameSink&) = delete;
  FrameSink& operator=(const FrameSink&) = delete;

  /// Queues the next frame; waits while too many are queued. Throws what failed in writing.
  void add(Picture&& frame);

  /// Writes what is still queued, the movie's end and the contact sheet.
  void finish();

private:
  void work();
  void writeFrame(const Picture& rendered);
  void writePicture(const Picture& picture, const std::string& name);
  void appendToMovie(const Picture& picture);
  void keepForContact(const Picture& picture);
  void stop();
  std::filesystem::path temporary(const std::string& name) const;
  void publish(const std::string& name);

  FrameSinkOptions options;
  bool madeFolder = false;
  int written = 0;
  std::vector<int> contact;
  std::vector<Picture> thumbnails;
  vtkSmartPointer<vtkOggTheoraWriter> movie;

  std::mutex guard;
  std::condition_variable changed;
  std::deque<Picture> queue;
  bool closed = false;
  std::exception_ptr failure;
  std::thread worker;
};
} // namespace hachure::program

#endif
