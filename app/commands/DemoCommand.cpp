// SPDX-License-Identifier: Apache-2.0
#include "app/commands/DemoCommand.h"

#include "app/steps/Arguments.h"
#include "core/demo/DemoStudy.h"
#include "ui/base/ErrorText.h"

#include <cstdio>

namespace app {

namespace {

int runDemo(const Arguments& arguments)
{
    if (arguments.rest().size() != 1)
        return reportUsageError("demo", QStringLiteral("it needs one folder"));
    const QString& folder = arguments.rest().first();
    const auto written = core::makeDemoStudy({}).and_then(
        [&](const core::DemoStudy& study) { return core::writeDemoStudy(folder, study); });
    if (!written) {
        std::fprintf(stderr, "burin demo: %s\n", qPrintable(ui::errorText(written.error())));
        return 1;
    }
    std::printf("%s\n", qPrintable(folder));
    return 0;
}

} // namespace

const Command demoCommand{.name = "demo",
    .words = "DIR",
    .usage = "DIR",
    .summary = "writes the demonstration study: a CT of a head, made by formulas",
    .run = runDemo};

} // namespace app
