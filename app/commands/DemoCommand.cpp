// SPDX-License-Identifier: Apache-2.0
#include "app/commands/DemoCommand.h"

#include "core/demo/DemoStudy.h"
#include "ui/base/ErrorText.h"

#include <cstdio>

namespace app {

int runDemo(const QStringList& arguments)
{
    if (arguments.size() != 1 || arguments.first().startsWith(QLatin1Char('-'))) {
        std::fprintf(stderr, "usage: burin demo DIR\n");
        return 2;
    }
    const QString& folder = arguments.first();
    const auto written = core::makeDemoStudy({}).and_then(
        [&](const core::DemoStudy& study) { return core::writeDemoStudy(folder, study); });
    if (!written) {
        std::fprintf(stderr, "burin demo: %s\n", qPrintable(ui::errorText(written.error())));
        return 1;
    }
    std::printf("%s\n", qPrintable(folder));
    return 0;
}

} // namespace app
