// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

namespace app {

/// `burin find NODE [filters] [--json]`: the studies at a DICOM node, or the series of one.
int runFind(const QStringList& arguments);

} // namespace app
