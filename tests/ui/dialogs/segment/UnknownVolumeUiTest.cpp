// SPDX-License-Identifier: Apache-2.0
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WindowFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"
#include "ui/base/NumberText.h"
#include "ui/dialogs/segment/BetweenSlicesDialog.h"
#include "ui/dialogs/segment/ThresholdDialog.h"
#include "ui/workspace/SegmentActions.h"

#include <QLabel>
#include <QSettings>
#include <QTimer>
#include <QtTest>

#include <utility>

namespace unknownVolumeUiTest {

namespace {

core::LoadedVolume withoutSpacing()
{
    core::LoadedVolume study = test::smallStudy();
    study.volume.problems.push_back({.kind = core::VolumeProblem::Kind::AssumedSpacing,
        .said = {core::ProblemCode::SpacingAssumed}});
    return study;
}

/// The upper half of its slices lie three times as far apart as the lower half.
core::LoadedVolume withUnevenSlices()
{
    core::LoadedVolume study = test::smallStudy();
    core::VolumeGeometry& geometry = study.volume.geometry;
    glm::dvec3 place = geometry.originLps();
    for (int k = 0; k < geometry.size.z; ++k) {
        geometry.slicePositions.push_back(place);
        place.z += k < geometry.size.z / 2 ? 0.75 : 2.25;
    }
    return study;
}

/// A segment that was drawn on two axial slices.
struct Fixture : test::WindowFixture {
    explicit Fixture(core::LoadedVolume study)
        : WindowFixture(std::move(study))
    {
        apply(test::addSegment("Organ"));
        const core::VolumeGeometry& geometry = workspace.volume()->geometry;
        for (const double slice : {8.0, 16.0})
            apply(test::paintDiscAt(
                1, geometry.toWorld(glm::dvec3(20.0, 18.0, slice)), geometry.direction()[2], 4.0));
        workspace.setActiveSegment(1);
        // As the engine's thread wakes the window in the program.
        QObject::connect(&wakeUp, &QTimer::timeout, [this] {
            if (core::EditSession* open = workspace.session())
                open->poll();
        });
        wakeUp.start(10);
    }
    template <typename Dialog> [[nodiscard]] Dialog& opened(const char* action)
    {
        window.actionTable()[QLatin1String(action)].trigger();
        return *window.findChild<Dialog*>();
    }
    [[nodiscard]] std::int64_t voxels() { return session().document().segment(1)->voxels; }

    QTimer wakeUp;
};

QString textOf(const QWidget& dialog, const char* name)
{
    return dialog.findChild<QLabel*>(QLatin1String(name))->text();
}

} // namespace

/// Dialogs about a segment of which only the number of its voxels is known, or nearly.
class UnknownVolumeUiTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        QSettings().remove(QStringLiteral("between"));
    }

    void withoutSpacingDialogsTellVoxels()
    {
        Fixture fixture(withoutSpacing());
        const QString now = QStringLiteral("%1 voxels").arg(ui::countText(fixture.voxels()));
        const QString both = ui::partsText(
            fixture.workspace, QStringLiteral("A"), 1, QStringLiteral("B"), fixture.voxels());
        QCOMPARE(both, QStringLiteral("A: 1 voxel · B: ") + now);

        auto& between = fixture.opened<ui::BetweenSlicesDialog>("segments.fillBetween");
        QTRY_VERIFY(textOf(between, "betweenResult").startsWith(QStringLiteral("Fills 7 empty")));
        const QString result = textOf(between, "betweenResult");
        QVERIFY2(result.endsWith(QStringLiteral(" voxels")), qPrintable(result));
        QVERIFY2(!result.contains(QStringLiteral("mL")), qPrintable(result));
        const QString row = textOf(between, "betweenNow");
        QVERIFY2(row.contains(now) && !row.contains(QStringLiteral("mL")), qPrintable(row));
        between.close();

        auto& threshold = fixture.opened<ui::ThresholdDialog>("segments.threshold");
        QTRY_VERIFY(textOf(threshold, "thresholdNow").contains(QStringLiteral("voxels\nNow: ")));
        const QString text = textOf(threshold, "thresholdNow");
        QVERIFY2(text.endsWith(QStringLiteral("Now: ") + now), qPrintable(text));
        QVERIFY2(!text.contains(QStringLiteral("mL")), qPrintable(text));
        threshold.close();
    }

    void withUnevenSlicesMillilitresAreEstimates()
    {
        Fixture fixture(withUnevenSlices());
        const double millilitres = double(fixture.voxels()) * 1.5 / 1000.0;
        auto& threshold = fixture.opened<ui::ThresholdDialog>("segments.threshold");
        const QString now = QStringLiteral("Now: %1 voxels, ≈ %2")
                                .arg(ui::countText(fixture.voxels()), ui::volumeText(millilitres));
        const QString text = textOf(threshold, "thresholdNow");
        QVERIFY2(text.endsWith(now), qPrintable(text));
        threshold.close();
    }
};

BURIN_WINDOW_TEST(UnknownVolumeUiTest)

} // namespace unknownVolumeUiTest

#include "UnknownVolumeUiTest.moc"
