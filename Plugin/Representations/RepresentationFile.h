// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A file that a representation has read: whether it must be read again, and who writes files.
 */
#ifndef RepresentationFile_h
#define RepresentationFile_h

#include <string>

class RepresentationFile
{
public:
  /// Whether this is not the file of the last call, or has changed since. Empty: no file.
  bool IsNew(const std::string& fileName);

  /// Whether this process is the first one of those with the files.
  static bool IsWriter();

private:
  struct State
  {
    std::string Name;
    long Time = 0; // of the last change, in seconds
    unsigned long Length = 0;
    bool operator==(const State& other) const;
  };
  State Known;
};

#endif
