// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QJsonObject>

namespace app {

/// One object on one line of stdout, out of the program when this returns.
void printJsonLine(const QJsonObject& object);

} // namespace app
