// SPDX-License-Identifier: Apache-2.0
#include "app/steps/TracedRun.h"

#include "app/steps/Arguments.h"
#include "core/base/files/StagedFile.h"
#include "core/base/trace/Trace.h"

#include <QFile>

#include <algorithm>
#include <string>

namespace app {

namespace {

core::Result<void> write(const std::string& json, const QString& path)
{
    core::Result<core::StagedFile> staged = core::StagedFile::create(path, false);
    if (!staged)
        return tl::unexpected(staged.error());
    QFile file(staged->path());
    if (!file.open(QIODevice::WriteOnly | QIODevice::Truncate)
        || file.write(json.data(), qint64(json.size())) != qint64(json.size()) || !file.flush())
        return core::failure(core::ErrorCode::FileUnwritable, path, file.errorString());
    file.close();
    return staged->commit();
}

} // namespace

std::vector<Option> traceOption()
{
    return {{"trace", "FILE.json",
        "writes what took how long into a new file, which Perfetto and chrome://tracing show: "
        "kernels and draws on the graphics processor, the engine's commands, tasks, pictures, and "
        "events of the window"}};
}

int traced(const Arguments& arguments, int (*run)(const Arguments&))
{
    if (!arguments.has("trace"))
        return run(arguments);
    const QString file = arguments.value("trace");
    // No --force replaces it: what else that would replace has nothing to do with a trace.
    if (const core::Result<void> fits = core::checkFileTarget(file, false); !fits)
        return reportFailure(fits.error().code == core::ErrorCode::FileExists
                ? core::Error{core::ErrorCode::FileUnwritable,
                    {file, core::Clause(QStringLiteral("a trace is written into a new file"))}}
                : fits.error());
    core::Trace::begin();
    const int status = run(arguments);
    const std::string json = core::Trace::end();
    constexpr int wrongArguments = 2;
    if (status == wrongArguments)
        return status;
    if (const core::Result<void> written = write(json, file); !written)
        return std::max(reportFailure(written.error()), status);
    return status;
}

} // namespace app
