// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

namespace app {

/// `burin compare MASK REFERENCE --study PATH [--series UID] [--repair REPAIRS] [--segment NAME]
/// [--reference NAME] [--json]`: how far a mask is from the one that is held for the truth.
int runCompare(const QStringList& arguments);

} // namespace app
