// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QJsonObject>

namespace app {

/// Prints one object on one line of stdout, and flushes it before it returns.
void printJsonLine(const QJsonObject& object);

} // namespace app
