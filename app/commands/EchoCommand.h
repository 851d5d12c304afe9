// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

namespace app {

/// `burin echo NODE [--json]`: whether a DICOM node answers.
int runEcho(const QStringList& arguments);

} // namespace app
