// SPDX-License-Identifier: Apache-2.0
#include "app/window/Application.h"
#include "app/window/PrivateSettings.h"
#include "core/edits/EditJson.h"
#include "core/session/EditSession.h"
#include "core/study/StudyLoader.h"
#include "tests/benchmarks/pacing/PacedApplication.h"
#include "tests/benchmarks/pacing/PacedHand.h"
#include "tests/benchmarks/pacing/PacingPlot.h"
#include "tests/benchmarks/pacing/PacingRecorder.h"
#include "tests/support/cases/growth/GrowToClosure.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SharedData.h"
#include "ui/base/ErrorText.h"
#include "ui/settings/growth/GrowSettings.h"
#include "ui/views/ViewGrid.h"
#include "ui/window/MainWindow.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>

namespace {

constexpr double secondsOfEach = 12.0;
constexpr double secondsOfRehearsal = 1.5;
constexpr int patienceMs = 600'000;
/// So that a step takes some voxels.
constexpr int generationsBefore = 40;

QString wordsOf(const core::Result<void>& result)
{
    return result ? QString() : ui::errorText(result.error());
}

/// The window works with a home of its own, except for the kernels that a software driver has
/// compiled: that would take most of a minute.
void moveHome(const QTemporaryDir& home)
{
    std::error_code failed; // then they are compiled in that home
    const auto program = std::filesystem::read_symlink("/proc/self/exe", failed);
    const auto shaders = program.parent_path() / "compiled-shaders";
    std::filesystem::create_directories(shaders, failed);
    if (!failed && !qEnvironmentVariableIsSet("MESA_SHADER_CACHE_DIR"))
        qputenv("MESA_SHADER_CACHE_DIR", QByteArray(shaders.c_str()));
    for (const char* name : {"XDG_STATE_HOME", "XDG_CACHE_HOME", "XDG_CONFIG_HOME"})
        qputenv(name, home.filePath(QLatin1String(name)).toUtf8());
}

/// A path, or the name of a case of the shared data.
QString studyAt(const QString& named)
{
    if (QFileInfo::exists(named))
        return named;
    const test::SharedCase data = test::sharedCase(named);
    if (data.source.isEmpty())
        return {};
    return data.unpacked.isEmpty() ? data.source + QStringLiteral("/dicom") : data.unpacked;
}

class Pacing {
public:
    Pacing(bench::PacedApplication& application, app::Application& burin)
        : m_window(burin.window())
        , m_workspace(burin.workspace())
        , m_recorder(application, m_window.views())
    {
    }

    /// @return why there is no record; empty: there is one
    QString measure(const QString& study, bench::PacingRecord& record)
    {
        core::Result<core::LoadedVolume> loaded = core::loadVolume(study);
        if (!loaded)
            return ui::errorText(loaded.error());
        m_window.resize(1600, 950);
        m_window.show();
        m_window.opener().open(study);
        if (!wait([this] { return !m_window.opener().busy(); }) || !m_workspace.session())
            return QStringLiteral("the study does not open");
        if (const QString why = prepare(*loaded); !why.isEmpty())
            return why;
        loaded = core::LoadedVolume();
        bench::PacedHand hand(m_window, m_recorder);
        // What is used for the first time is compiled, which is no part of any pace.
        if (!rest())
            return QStringLiteral("the pictures do not come to rest");
        std::fprintf(stderr, "pacing: a rehearsal\n");
        m_recorder.begin();
        hand.work(secondsOfRehearsal);
        static_cast<void>(m_recorder.end());
        if (!rest())
            return QStringLiteral("the pictures do not come to rest");
        const std::size_t rows = history().rows().size();
        std::fprintf(stderr, "pacing: five times %.0f s\n", secondsOfEach);
        m_recorder.begin();
        hand.work(secondsOfEach);
        record = m_recorder.end();
        if (!rest())
            return QStringLiteral("the pictures do not come to rest");
        std::fprintf(stderr, "pacing: %zu steps were done\n", history().rows().size() - rows);
        return missing(rows);
    }

private:
    static bool wait(const std::function<bool()>& condition)
    {
        return QTest::qWaitFor(condition, patienceMs);
    }
    [[nodiscard]] const core::History& history() const { return m_workspace.session()->history(); }
    [[nodiscard]] bool rest() const
    {
        return wait([this] { return m_workspace.session()->idle() && m_window.views().refined(); });
    }

    /// A segment of what the 3D view shows, with seeds all over, grown a little.
    QString prepare(const core::LoadedVolume& loaded)
    {
        core::EditSession& session = *m_workspace.session();
        const core::VolumeGeometry& geometry = loaded.volume.geometry;
        const core::VoxelEncoding& encoding = loaded.volume.encoding;
        const double lower = m_workspace.volumeDisplay().surfaceThreshold;
        const double upper = loaded.volume.maximum;
        std::vector<glm::dvec3> seeds;
        for (const glm::ivec3& voxel : test::seedsOnDiagonal(geometry.size, loaded.codes,
                 encoding.lowestCodeAtLeast(lower), encoding.highestCodeAtMost(upper)))
            seeds.push_back(geometry.toWorld(glm::dvec3(voxel)));
        if (seeds.empty())
            return QStringLiteral("the study has no surface for a seed");
        ui::GrowSettings settings = m_workspace.growSettings();
        settings.lower = lower;
        settings.upper = upper;
        m_workspace.setGrowSettings(settings);
        for (const core::Edit& edit : {test::newSegment(QStringLiteral("Grown"), 0x59C07A),
                 test::seedAt(1, seeds), test::growBetween(lower, upper, generationsBefore)}) {
            core::Result<void> done = session.apply(edit);
            if (done)
                done = session.settle();
            if (const QString why = wordsOf(done); !why.isEmpty())
                return why;
        }
        m_workspace.setActiveSegment(1);
        return {};
    }

    /// What should have been done and was not, so that its pace tells nothing.
    [[nodiscard]] QString missing(std::size_t rowsBefore) const
    {
        bool drilled = false;
        bool grew = false;
        const auto& rows = history().rows();
        for (std::size_t row = std::min(rowsBefore, rows.size()); row < rows.size(); ++row) {
            const QString name = core::editName(rows[row].edit);
            drilled = drilled || name == QLatin1String("drill");
            grew = grew || name == QLatin1String("grow");
        }
        if (drilled && grew)
            return {};
        return drilled ? QStringLiteral("nothing was grown")
                       : QStringLiteral("nothing was drilled");
    }

    ui::MainWindow& m_window;
    ui::Workspace& m_workspace;
    bench::PacingRecorder m_recorder;
};

bool write(const QString& file, const QByteArray& text)
{
    QFile out(file);
    return out.open(QIODevice::WriteOnly) && out.write(text) == text.size();
}

bool write(const QDir& folder, const bench::PacingRecord& record)
{
    const bench::PacingRecord::Gap longest = record.longestGap();
    const QJsonObject summary{{QStringLiteral("figures"), record.figures()},
        {QStringLiteral("longest"),
            QJsonObject{{QStringLiteral("ms"), longest.lasted},
                {QStringLiteral("phase"), record.phaseAt(longest.begin)},
                {QStringLiteral("event"), longest.name},
                {QStringLiteral("eventMs"), longest.ofThat}}}};
    return write(folder.filePath(QStringLiteral("pacing.csv")), record.csv())
        && write(folder.filePath(QStringLiteral("pacing.json")), QJsonDocument(summary).toJson())
        && bench::pacingPlot(record).save(folder.filePath(QStringLiteral("frame-pacing.png")));
}

} // namespace

/// A minute of work in the window by a script: which pictures came when, and for how long the
/// window heard nobody.
int main(int argc, char** argv)
{
    const QTemporaryDir home;
    moveHome(home);
    bench::PacedApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("burin"));
    QCoreApplication::setOrganizationName(QStringLiteral("burin"));
    app::keepSettingsPrivate();
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() != 3) {
        std::fprintf(stderr, "usage: burin_pacing STUDY|CASE FOLDER\n");
        return 2;
    }
    const QString study = studyAt(arguments[1]);
    const QDir folder(arguments[2]);
    QString why;
    bench::PacingRecord record;
    if (study.isEmpty()) {
        why = QStringLiteral("there is no study %1").arg(arguments[1]);
    } else if (auto burin = app::Application::create(); !burin) {
        why = ui::errorText(burin.error());
    } else {
        Pacing pacing(application, **burin);
        why = pacing.measure(study, record);
    }
    if (why.isEmpty() && !(folder.mkpath(QStringLiteral(".")) && write(folder, record)))
        why = QStringLiteral("nothing could be written into %1").arg(folder.path());
    if (!why.isEmpty()) {
        std::fprintf(stderr, "pacing: no record: %s\n", qPrintable(why));
        return 1;
    }
    return 0;
}
