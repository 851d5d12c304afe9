// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

namespace app {

/// `burin send NODE PATH… [--json]`: stores DICOM files at a node.
int runSend(const QStringList& arguments);

} // namespace app
