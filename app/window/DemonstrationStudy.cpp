// SPDX-License-Identifier: Apache-2.0
#include "app/window/DemonstrationStudy.h"

#include "app/Version.h"
#include "core/demo/DemoStudy.h"
#include "core/study/StudyLoader.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace app {

QString demonstrationFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation)
        + QStringLiteral("/burin/demonstration-" BURIN_VERSION);
}

core::Result<core::LoadedVolume> loadDemonstration(
    const core::Progress& progress, const core::EarlySliceListener& early)
{
    const QString folder = demonstrationFolder();
    if (!QFileInfo::exists(folder)) {
        const auto study = core::makeDemoStudy(progress);
        if (!study)
            return tl::unexpected(study.error());
        QDir().mkpath(QFileInfo(folder).path());
        if (const auto written = core::writeDemoStudy(folder, *study); !written)
            return tl::unexpected(written.error());
    }
    // Its truth lies beside it; the series is what is opened.
    const auto study = core::Study::scan(folder, progress);
    if (!study)
        return tl::unexpected(study.error());
    for (const core::SeriesEntry* entry : study->listing().candidates()) {
        if (entry->identity.modality == QLatin1String("CT"))
            return study->load(entry->key, progress, early);
    }
    return core::failure(core::ErrorCode::NoImages, folder);
}

} // namespace app
