// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ErrorCollector.h"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <algorithm>
#include <mutex>

namespace hachure::program
{
namespace
{
class CollectingWindow : public vtkOutputWindow
{
public:
  static CollectingWindow* New();
  vtkTypeMacro(CollectingWindow, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayWarningText(const char*) override {}
  void DisplayGenericWarningText(const char*) override {}
  void DisplayDebugText(const char*) override {}
  void DisplayErrorText(const char* text) override
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    // The listing of a shader that does not compile comes before the reason.
    if (this->First.empty() || this->First.find("#version") != std::string::npos)
    {
      this->First = text;
    }
  }
  std::string GetFirst()
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    return this->First;
  }

private:
  std::mutex Guard;
  std::string First;
};
vtkStandardNewMacro(CollectingWindow);

/// "ERROR: In file, line 1\nvtkThing (0x12): the message\n\n" becomes "the message".
std::string oneLine(std::string text)
{
  const auto address = text.find("(0x");
  const auto start = address == std::string::npos ? address : text.find("): ", address);
  if (start != std::string::npos)
  {
    text = text.substr(start + 3);
  }
  text.erase(text.find_last_not_of(" \n") + 1);
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}
} // namespace

//----------------------------------------------------------------------------
ErrorCollector::ErrorCollector()
  : previous(vtkOutputWindow::GetInstance())
  , window(vtkSmartPointer<CollectingWindow>::New())
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkOutputWindow::SetInstance(this->window);
}

//----------------------------------------------------------------------------
ErrorCollector::~ErrorCollector()
{
  vtkOutputWindow::SetInstance(this->previous);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_INFO);
}

//----------------------------------------------------------------------------
std::string ErrorCollector::first() const
{
  return oneLine(static_cast<CollectingWindow*>(this->window.Get())->GetFirst());
}
} // namespace hachure::program
