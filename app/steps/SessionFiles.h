// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <QString>

namespace app {

/// Where the working sessions lie: $XDG_STATE_HOME/burin/sessions, else
/// ~/.local/state/burin/sessions. Made if it is not there.
[[nodiscard]] QString sessionFolder();

/// The working session of a volume: the same file whenever the same voxels of the same series are
/// opened, from wherever. Its name says nothing about the patient.
[[nodiscard]] QString sessionFile(const core::Volume& volume);

/// Whether a file lies there: a working session, not a file of the user's own.
[[nodiscard]] bool isWorkingSession(const QString& file);

} // namespace app
