// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/Volume.h"

#include <QString>

namespace app {

/// The folder of the working sessions: $XDG_STATE_HOME/burin/sessions, else
/// ~/.local/state/burin/sessions. Created if it does not exist.
[[nodiscard]] QString sessionFolder();

/// The file of a volume's working session: the same one whenever the same voxels of the same series
/// are opened, from any place. Its name reveals nothing about the patient.
[[nodiscard]] QString sessionFile(const core::Volume& volume);

/// Whether a file is in that folder: a working session, and not a file that the user has named.
[[nodiscard]] bool isWorkingSession(const QString& file);

} // namespace app
