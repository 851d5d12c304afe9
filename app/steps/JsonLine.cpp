// SPDX-License-Identifier: Apache-2.0
#include "app/steps/JsonLine.h"

#include <QJsonDocument>

#include <cstdio>

namespace app {

void printJsonLine(const QJsonObject& object)
{
    std::printf("%s\n", QJsonDocument(object).toJson(QJsonDocument::Compact).constData());
    std::fflush(stdout);
}

} // namespace app
