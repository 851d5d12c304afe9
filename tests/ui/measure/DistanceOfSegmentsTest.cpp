// SPDX-License-Identifier: Apache-2.0
#include "ui/measure/DistanceOfSegments.h"

#include "core/measure/MeasuredSize.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/fixtures/WorkspaceFixture.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/PlainEdits.h"

#include <QSignalSpy>
#include <QtTest>

#include <algorithm>
#include <cmath>

namespace distanceOfSegmentsTest {

namespace {

constexpr double lowerValue = 100.0; ///< slices 0 and 1
constexpr double upperValue = 200.0; ///< slice 4 and above

/// Ten slices, the upper ones five times as far apart as the lower ones.
core::LoadedVolume unevenStudy()
{
    core::LoadedVolume loaded;
    core::Volume& volume = loaded.volume;
    volume.geometry.size = {8, 8, 10};
    const double places[] = {0, 1, 2, 3, 4, 9, 14, 19, 24, 29};
    for (const double z : places)
        volume.geometry.slicePositions.emplace_back(0.0, 0.0, z);
    volume.geometry.indexToWorld[2][2] = 29.0 / 9.0; // as they are shown
    volume.maximum = upperValue;
    for (int k = 0; k < 10; ++k) {
        const double value = k < 2 ? lowerValue : (k < 4 ? 0.0 : upperValue);
        loaded.codes.insert(loaded.codes.end(), 64, std::uint16_t(value));
    }
    return loaded;
}

} // namespace

class DistanceOfSegmentsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    /// Both ends are kept where views show them, as those that a pen measures; the length is that
    /// between the places where they truly lie.
    void betweenUnevenSlicesItIsTheTrueOne()
    {
        test::WorkspaceFixture fixture(unevenStudy());
        fixture.apply(test::newSegment(QStringLiteral("Lower")));
        fixture.apply(test::newSegment(QStringLiteral("Upper")));
        fixture.apply(test::thresholdOf(1, lowerValue, lowerValue));
        fixture.apply(test::thresholdOf(2, upperValue, upperValue));
        const core::Document& document = fixture.session().document();
        QCOMPARE(document.segment(1)->voxels, std::int64_t(2 * 64));
        QCOMPARE(document.segment(2)->voxels, std::int64_t(6 * 64));
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        ui::measureDistance(fixture.workspace, 1, 2);
        QCOMPARE(said.front().front().toString(),
            QStringLiteral("The distance from 'Lower' to 'Upper' is being measured …"));
        QTRY_VERIFY((fixture.session().poll(), said.size() == 2)); // answers come when asked for
        fixture.settle();
        QCOMPARE(document.measurements.size(), std::size_t(1));
        const core::Measurement& kept = document.measurements.front();
        const core::Volume& volume = *fixture.workspace.volume();
        QVERIFY(std::abs(volume.geometry.toIndex(kept.pointsLps.front()).z - 1.5) < 0.01);
        QVERIFY(std::abs(volume.geometry.toIndex(kept.pointsLps.back()).z - 3.5) < 0.01);
        const core::MeasuredSize size = core::measuredSize(kept, volume);
        QVERIFY(size.length && !size.inVoxels);
        QVERIFY2(std::abs(*size.length - 2.0) < 0.01, qPrintable(QString::number(*size.length)));
        QCOMPARE(said.back().front().toString(),
            QStringLiteral("'Lower' and 'Upper' are 2.0 mm apart; it is in the panel "
                           "Measurements"));
    }

    /// Who asks again is answered once, and what was asked before is dropped.
    void aNewCallEndsTheOldOne()
    {
        test::WorkspaceFixture fixture(unevenStudy());
        fixture.apply(test::newSegment(QStringLiteral("Lower")));
        fixture.apply(test::newSegment(QStringLiteral("Upper")));
        fixture.apply(test::thresholdOf(1, lowerValue, lowerValue));
        fixture.apply(test::thresholdOf(2, upperValue, upperValue));
        QSignalSpy said(&fixture.workspace, &ui::Workspace::said);
        QSignalSpy failed(&fixture.workspace, &ui::Workspace::failed);
        ui::measureDistance(fixture.workspace, 1, 2);
        ui::measureDistance(fixture.workspace, 2, 1);
        const auto answers = [&said] {
            return std::count_if(said.begin(), said.end(), [](const QList<QVariant>& each) {
                return each.front().toString().contains(QStringLiteral(" apart"));
            });
        };
        QTRY_VERIFY((fixture.session().poll(), answers() > 0));
        // An answer to the first call would come about then.
        for (int round = 0; round < 10; ++round) {
            fixture.session().poll();
            QTest::qWait(10);
        }
        fixture.settle();
        QVERIFY(
            said.back().front().toString().startsWith(QStringLiteral("'Upper' and 'Lower' are ")));
        QCOMPARE(answers(), std::ptrdiff_t(1));
        QCOMPARE(fixture.session().document().measurements.size(), std::size_t(1));
        QVERIFY(failed.isEmpty());
        QVERIFY(!fixture.workspace.findChild<QObject*>(QStringLiteral("distanceOfSegments")));
    }
};

BURIN_TEST(DistanceOfSegmentsTest)

} // namespace distanceOfSegmentsTest

#include "DistanceOfSegmentsTest.moc"
