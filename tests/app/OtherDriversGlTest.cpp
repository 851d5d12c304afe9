// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/edits/kinds/sculpt/BrushStroke.h"
#include "core/nifti/NiftiWriter.h"
#include "core/session/EditSession.h"
#include "core/study/StudyLoader.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/CutEdits.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "tests/support/servers/BurinProgram.h"

#include <QScopeGuard>
#include <QTemporaryDir>
#include <QtTest>

#include <memory>
#include <vector>

namespace otherDriversGlTest {

namespace {

using Settings = std::vector<std::pair<const char*, const char*>>;

/// A stroke of every tool, and back.
std::vector<core::Edit> everyTool()
{
    const core::Edit drill = test::drillAt(-6);
    const test::StrokeFacts at = test::factsOfStroke(drill);
    const core::ToolMask rounded{.kind = core::ToolMask::Kind::Rounded,
        .widthMm = 9.0,
        .heightMm = 6.0,
        .rotationDegrees = 30.0,
        .softnessMm = 1.0};
    const core::Edit rate =
        test::drillWith({.mask = rounded, .mode = core::DrillMode::Rate}, test::drillAt(5));
    const core::Edit restore = test::drillWith({.restore = true}, test::drillAt(-4));
    const core::ToolMask ellipse{
        .kind = core::ToolMask::Kind::Ellipse, .widthMm = 8.0, .heightMm = 5.0};
    const std::vector<core::PenSample> path{
        {.xMm = 0.0, .yMm = 7.0}, {.xMm = 4.0, .yMm = 8.0, .tSeconds = 0.1}};
    const core::Edit laser = test::laserWith({.view = at.view,
        .mask = ellipse,
        .depthMm = 6.0,
        .surfaceThreshold = at.surfaceThreshold,
        .samples = path});
    const core::Edit peel =
        test::peelWith({.view = at.view, .depthMm = 2.5, .surfaceThreshold = at.surfaceThreshold},
            {{-9.0, -9.0}, {7.0, -8.0}, {9.0, 2.0}, {-5.0, 3.0}});
    const core::Edit scissors = test::scissorsWith(
        {.view = at.view, .depthMm = 9.0, .surfaceThreshold = at.surfaceThreshold},
        {{2.0, 2.0}, {12.0, 4.0}, {6.0, 13.0}});
    core::BrushStroke carve;
    carve.path.radiusMm = 3.0;
    carve.path.pointsLps = {at.view.targetLps, at.view.targetLps + glm::dvec3(7.0, 2.0, 5.0)};
    core::BrushStroke fill = carve;
    fill.path.radiusMm = 2.0;
    fill.restore = true;
    const core::Edit paint = test::paintAt(1, carve.path.pointsLps, carve.path.radiusMm);
    return {test::addSegment("Brain"), test::addSegment("Skull"), test::seedInBrain(1),
        test::growBrain(), drill, rate, laser, restore, peel, scissors, carve, fill, paint,
        core::ReviseStroke{.row = 5, .depthMm = 7.0}};
}

} // namespace

/// A session of the oracle's, carried out again by other drivers and driver settings of Mesa, in
/// processes of their own: the same hash after every row (DESIGN §3).
class OtherDriversGlTest : public QObject {
    Q_OBJECT

private:
    QTemporaryDir m_folder;
    QString m_session;
    std::size_t m_rows = 0;
    QByteArray m_usual; ///< how GL is called here

    static QByteArray renderer()
    {
        for (const QByteArray& line :
            test::burin({QStringLiteral("info"), QStringLiteral("--gl")}).output.split('\n')) {
            if (line.startsWith("GL_RENDERER"))
                return line.mid(11).trimmed();
        }
        return {};
    }

private Q_SLOTS:
    void initTestCase()
    {
        m_usual = renderer();
        QVERIFY(!m_usual.isEmpty());
        const core::LoadedVolume small = test::smallStudy();
        std::vector<std::int16_t> values;
        for (const std::uint16_t code : small.codes)
            values.push_back(std::int16_t(small.volume.encoding.value(code)));
        const QString study = m_folder.filePath(QStringLiteral("small.nii.gz"));
        QVERIFY(core::writeNifti(
            study, {.geometry = small.volume.geometry, .voxels = values, .description = {}}));
        m_session = m_folder.filePath(QStringLiteral("s.burin"));
        reference::ReferenceEngine oracle;
        const auto session =
            *core::EditSession::create(oracle, *core::loadVolume(study), {.file = m_session});
        for (const core::Edit& edit : everyTool()) {
            QVERIFY(session->apply(edit));
            QVERIFY(session->settle());
            ++m_rows;
            QCOMPARE(session->history().rows().size(), m_rows);
        }
    }
    void init() { test::failOnUnexpectedMessages(); }

    void replays_data()
    {
        QTest::addColumn<Settings>("settings");
        QTest::addColumn<QByteArray>("expected"); // in the renderer's name; empty: as always
        const auto row = [](const char* name, const Settings& settings, const char* expected = "") {
            QTest::newRow(name) << settings << QByteArray(expected);
        };
        row("as it is", {});
        row("vectors of 128 bits", {{"LP_NATIVE_VECTOR_WIDTH", "128"}}, "128 bits");
        row("without threads", {{"LP_NUM_THREADS", "0"}});
        row("many threads", {{"LP_NUM_THREADS", "7"}});
        row("other sampling code",
            {{"GALLIVM_PERF", "no_aos_sampling,no_quad_lod,no_filter_hacks"}});
        row("code not optimised", {{"GALLIVM_PERF", "nopt"}});
        // Another implementation: an interpreter. It knows all that is needed but says less.
        row("softpipe",
            {{"GALLIUM_DRIVER", "softpipe"}, {"MESA_GL_VERSION_OVERRIDE", "4.5"},
                {"MESA_GLSL_VERSION_OVERRIDE", "450"}},
            "softpipe");
    }
    void replays()
    {
        QFETCH(Settings, settings);
        QFETCH(QByteArray, expected);
        if (!m_usual.startsWith("llvmpipe") && !settings.empty())
            QSKIP(qPrintable(QStringLiteral("these settings are llvmpipe's; here is %1")
                                 .arg(QString::fromUtf8(m_usual))));
        for (const auto& [name, value] : settings)
            qputenv(name, value);
        const auto unset = qScopeGuard([&settings = settings] {
            for (const auto& [name, value] : settings)
                qunsetenv(name);
        });
        const QByteArray now = renderer();
        if (!now.contains(expected))
            QSKIP(qPrintable(QStringLiteral("the driver does not take the setting: it is %1")
                                 .arg(QString::fromUtf8(now))));
        qInfo("%s", now.constData());
        const test::Outcome replayed =
            test::burin({QStringLiteral("replay"), m_session, QStringLiteral("--verify")});
        QVERIFY2(replayed.status == 0, qPrintable(replayed.complaint));
    }
};

BURIN_TEST(OtherDriversGlTest)

} // namespace otherDriversGlTest

#include "OtherDriversGlTest.moc"
