// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

namespace app {

/// `burin demo DIR`: writes the demonstration study with its truth into a new folder.
int runDemo(const QStringList& arguments);

} // namespace app
