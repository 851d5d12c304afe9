// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

namespace app {

/// `burin get NODE --study UID [--series UID] --to FOLDER [--move PORT] [--json]`: downloads.
int runGet(const QStringList& arguments);

} // namespace app
