// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace app {

/// Makes the files of settings that the window writes readable to their owner alone: Burin's own,
/// which names the studies that were open last, and the one in which Qt's dialogs for files note
/// the folders that they showed. To be called before the first of them is written, when the
/// application has its name.
void keepSettingsPrivate();

} // namespace app
