// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/views/Measurements.h"

#include "core/edits/EditRows.h"
#include "core/edits/answers/RowFacts.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/kinds/Edit.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <utility>

namespace measurementTitlesTest {

using namespace core;

namespace {

/// Rows of measurements quote no other ones.
class NoPast : public Past {
public:
    [[nodiscard]] RowTitle headlineOf(std::int64_t) const override { return {}; }
    [[nodiscard]] StrokeParameters cutOf(std::int64_t) const override { return {}; }
};

QString nameOf(const Edit& edit, const Document& document)
{
    const EditStatistics statistics;
    const ChangeFacts facts;
    const NoPast past;
    return canonicalName(titleOf(edit,
        RowFacts{.statistics = statistics, .facts = facts, .document = document, .past = past}));
}

/// The names of a distance's rows: when it is kept, moved to what it is, and removed.
QStringList namesOf(Volume volume, const glm::dvec3& from, const glm::dvec3& to)
{
    Document document = initialDocument(std::move(volume));
    const AddMeasurement add{.fromLps = from, .toLps = to};
    QStringList names{nameOf(add, document)};
    if (!applyToDocument(add, document))
        return names;
    names += nameOf(MoveMeasurement{.measurement = 1, .pointsLps = {from, to}}, document);
    names += nameOf(RemoveMeasurement{.measurement = 1}, document);
    return names;
}

Volume volumeWith(const glm::dvec3& spacing)
{
    Volume volume;
    volume.geometry.size = {10, 10, 10};
    for (int axis = 0; axis < 3; ++axis)
        volume.geometry.indexToWorld[axis][axis] = spacing[axis];
    return volume;
}

} // namespace

/// The history states what a distance comes to, as the views and the panel do.
class MeasurementTitlesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// Sessions hold these names: they never change.
    void millimetresAreNamedAsEver()
    {
        QCOMPARE(namesOf(volumeWith({0.5, 0.5, 2.0}), {1, 2, 3}, {4, 6, 3}),
            (QStringList{QStringLiteral("Measure 5.0 mm"), QStringLiteral("Move distance 5.0 mm"),
                QStringLiteral("Remove measurement 5.0 mm")}));
    }

    void whereTheSpacingIsUnknownTheyAreVoxels()
    {
        Volume volume = volumeWith({0.5, 0.5, 1.0});
        volume.problems.push_back({.kind = VolumeProblem::Kind::AssumedSpacing,
            .said = {ProblemCode::SpacingAssumed},
            .caution = true});
        QCOMPARE(namesOf(volume, {0, 0, 2}, {1.5, 2.0, 2.0}),
            (QStringList{QStringLiteral("Measure distance 5.0 voxels"),
                QStringLiteral("Move distance 5.0 voxels"),
                QStringLiteral("Remove distance 5.0 voxels")}));
        // Within a slice it is known how far its pixels are apart.
        volume.problems.front().said = {ProblemCode::PicturesWithoutDistance};
        QCOMPARE(
            namesOf(volume, {0, 0, 2}, {1.5, 2.0, 2.0}).front(), QStringLiteral("Measure 2.5 mm"));
    }

    void betweenUnevenSlicesTheyAreTheTrueOnes()
    {
        Volume volume = volumeWith({1.0, 1.0, 29.0 / 9.0});
        for (const double z : {0.0, 1.0, 2.0, 3.0, 4.0, 9.0, 14.0, 19.0, 24.0, 29.0})
            volume.geometry.slicePositions.emplace_back(0.0, 0.0, z);
        QCOMPARE(
            namesOf(volume, volume.geometry.toWorld({2, 2, 1}), volume.geometry.toWorld({2, 2, 4})),
            (QStringList{QStringLiteral("Measure 3.0 mm"), QStringLiteral("Move distance 3.0 mm"),
                QStringLiteral("Remove measurement 3.0 mm")}));
    }
};

BURIN_TEST(MeasurementTitlesTest)

} // namespace measurementTitlesTest

#include "MeasurementTitlesTest.moc"
