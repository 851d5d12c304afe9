// SPDX-License-Identifier: Apache-2.0
#include "ui/measure/MeasureTexts.h"

#include "tests/support/program/TestProgram.h"

#include <QTest>

namespace measureTextsTest {

using Kind = core::Measurement::Kind;

namespace {

core::Volume volumeOf(const glm::dvec3& spacing)
{
    core::Volume volume;
    volume.geometry.size = {100, 100, 100};
    for (int axis = 0; axis < 3; ++axis)
        volume.geometry.indexToWorld[axis][axis] = spacing[axis];
    volume.unit = QStringLiteral("HU");
    volume.minimum = -1024.0;
    volume.maximum = 3071.0;
    return volume;
}

QStringList linesOf(const core::Measurement& measurement, const core::Volume& volume)
{
    return ui::sizeLines(measurement, core::measuredSize(measurement, volume));
}

} // namespace

class MeasureTextsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void sizesAreInTheirUnits_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QStringList>("known");
        QTest::addColumn<QStringList>("unknown");
        const auto row = [](Kind kind, const QStringList& known, const QStringList& unknown) {
            QTest::newRow(core::measurementWords[std::size_t(kind)])
                << int(kind) << known << unknown;
        };
        // 30 mm along columns and 40 mm along rows, in voxels of half a millimetre.
        row(Kind::Distance, {QStringLiteral("30.0 mm")}, {QStringLiteral("60.0 voxels")});
        row(Kind::Angle, {QStringLiteral("53.1°")}, {QStringLiteral("53.1°")});
        row(Kind::Ellipse, {QStringLiteral("3769.9 mm²"), QStringLiteral("80.0 × 60.0 mm")},
            {QStringLiteral("15079.6 voxels²"), QStringLiteral("160.0 × 120.0 voxels")});
        row(Kind::Rectangle, {QStringLiteral("1200.0 mm²"), QStringLiteral("40.0 × 30.0 mm")},
            {QStringLiteral("4800.0 voxels²"), QStringLiteral("80.0 × 60.0 voxels")});
        row(Kind::Outline, {QStringLiteral("600.0 mm²")}, {QStringLiteral("2400.0 voxels²")});
        row(Kind::Ball, {QStringLiteral("113.1 mL"), QStringLiteral("⌀ 60.0 mm")},
            {QStringLiteral("904779 voxels"), QStringLiteral("⌀ 120.0 voxels")});
        row(Kind::Probe, {}, {});
    }
    void sizesAreInTheirUnits()
    {
        QFETCH(const int, kind);
        QFETCH(const QStringList, known);
        QFETCH(const QStringList, unknown);
        core::Measurement measured{.id = 1, .kind = Kind(kind)};
        const glm::dvec3 at(5, 5, 10);
        measured.pointsLps = {at, at + glm::dvec3(30, 0, 0), at + glm::dvec3(0, 40, 0)};
        if (measured.kind != Kind::Outline)
            measured.pointsLps.resize(core::pointsOf(measured.kind));
        core::Volume volume = volumeOf(glm::dvec3(0.5));
        QCOMPARE(linesOf(measured, volume), known);
        measured.projected = true;
        QCOMPARE(linesOf(measured, volume), known + QStringList{QStringLiteral("projected")});
        measured.projected = false;
        volume.problems.push_back({.kind = core::VolumeProblem::Kind::AssumedSpacing,
            .said = {core::ProblemCode::SpacingAssumed}});
        QCOMPARE(linesOf(measured, volume), unknown);
    }

    void valuesHaveTheStudysUnit()
    {
        const core::Volume volume = volumeOf(glm::dvec3(1.0));
        const core::RegionStatistics values{
            .voxels = 240, .mean = 41.26, .deviation = 12.04, .minimum = -20.0, .maximum = 88.0};
        const core::Measurement ball{
            .id = 1, .kind = Kind::Ball, .pointsLps = {{0, 0, 0}, {5, 0, 0}}};
        const QStringList lines = ui::valueLines(ball, values, volume);
        QCOMPARE(lines.size(), 2);
        QVERIFY(lines[0].startsWith(QStringLiteral("mean 41")));
        QVERIFY(lines[0].endsWith(QStringLiteral("HU")));
        QCOMPARE(lines[1], QStringLiteral("−20 … 88 HU in 240"));
        const core::Measurement probe{.id = 2, .kind = Kind::Probe, .pointsLps = {{0, 0, 0}}};
        QCOMPARE(ui::valueLines(probe, values, volume), QStringList{QStringLiteral("41 HU")});
    }

    void middlesAreWhereOneLooks()
    {
        const std::vector<glm::dvec3> points{{0, 0, 0}, {6, 0, 0}, {0, 8, 0}};
        const auto middle = [&points](Kind kind) {
            return ui::middleOf({.id = 1, .kind = kind, .pointsLps = points});
        };
        QCOMPARE(middle(Kind::Distance), (glm::dvec3(3, 0, 0)));
        QCOMPARE(middle(Kind::Angle), (glm::dvec3(6, 0, 0)));
        QCOMPARE(middle(Kind::Ellipse), (glm::dvec3(0, 0, 0)));
        QCOMPARE(middle(Kind::Rectangle), (glm::dvec3(3, 4, 0)));
        QVERIFY(glm::distance(middle(Kind::Outline), glm::dvec3(2.0, 8.0 / 3.0, 0)) < 1e-12);
        QCOMPARE(middle(Kind::Ball), (glm::dvec3(0, 0, 0)));
    }
};

BURIN_TEST(MeasureTextsTest)

} // namespace measureTextsTest

#include "MeasureTextsTest.moc"
