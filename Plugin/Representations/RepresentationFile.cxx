// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RepresentationFile.h"

#include "vtkPVSession.h"
#include "vtkProcessModule.h"

#include "vtksys/SystemTools.hxx"

//------------------------------------------------------------------------------
bool RepresentationFile::State::operator==(const State& other) const
{
  return this->Name == other.Name && this->Time == other.Time && this->Length == other.Length;
}

//------------------------------------------------------------------------------
bool RepresentationFile::IsNew(const std::string& fileName)
{
  using vtksys::SystemTools;
  State state;
  state.Name = fileName;
  if (SystemTools::FileExists(fileName))
  {
    state.Time = SystemTools::ModifiedTime(fileName);
    state.Length = SystemTools::FileLength(fileName);
  }
  const bool isNew = !(state == this->Known);
  this->Known = state;
  return isNew;
}

//------------------------------------------------------------------------------
bool RepresentationFile::IsWriter()
{
  auto* const processes = vtkProcessModule::GetProcessModule();
  auto* const session = vtkPVSession::SafeDownCast(processes->GetActiveSession());
  return (!session || session->HasProcessRole(vtkPVSession::DATA_SERVER)) &&
    processes->GetPartitionId() == 0;
}
