// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

namespace app {

/// `burin replay FILE.burin --verify [--study PATH] [--series UID]`: carries out every row of a
/// session again, from nothing, branches included, and compares the state hash after each. The file
/// is only read.
int runReplay(const QStringList& arguments);

} // namespace app
