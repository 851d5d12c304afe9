// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

namespace app {

/// `burin mesh MASK --study PATH --out FILE [--series UID] [--repair REPAIRS] [--segment NAME]
/// [--vertices NUMBER] [--space lps|ras] [--json] [--force]`: the surface that refinement begins
/// with, of each segment of a mask, and what it is worth.
int runMesh(const QStringList& arguments);

} // namespace app
