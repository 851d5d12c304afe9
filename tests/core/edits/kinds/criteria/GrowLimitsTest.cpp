// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/criteria/GrowLimits.h"

#include "core/edits/EditJson.h"
#include "core/edits/EditQuantise.h"
#include "core/edits/document/DocumentEdits.h"
#include "core/edits/engine/EngineEdits.h"
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "core/edits/kinds/criteria/ToleranceEdits.h"
#include "core/edits/kinds/growth/ChangeInterval.h"
#include "core/edits/kinds/growth/GrowSteps.h"
#include "core/edits/kinds/parts/GrowBox.h"
#include "core/session/past/RecentGrowth.h"
#include "core/session/past/RowDependencies.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <cmath>

namespace growLimitsTest {

using namespace core;

namespace {

/// 20 × 16 × 10 voxels of 0.5 × 1 × 2 mm; i runs to −x, k to −z; value = 0.25 · code − 1024.
Volume smallVolume()
{
    Volume volume;
    volume.geometry.size = {20, 16, 10};
    volume.geometry.indexToWorld = glm::dmat4(glm::dvec4(-0.5, 0, 0, 0), glm::dvec4(0, 1, 0, 0),
        glm::dvec4(0, 0, -2, 0), glm::dvec4(100, -50, 30, 1));
    volume.encoding = {.rescaleSlope = 0.25, .rescaleIntercept = -1024};
    volume.minimum = -1024.0;
    volume.maximum = 976.0; // 8000 codes
    return volume;
}

GrowLimits limitsOf(const GrowCriteria& criteria, const Volume& volume = smallVolume())
{
    const Result<GrowLimits> limits = growLimits(criteria, volume, QStringLiteral("grow"));
    if (!limits)
        qFatal("refused");
    return *limits;
}

GrowCriteria everything()
{
    return {.lower = -20.5,
        .upper = 80.25,
        .connectivity = 18,
        .sigmas = 2.5,
        .difference = 12.5,
        .gradient = 30.0,
        .gradientDifference = 7.75,
        .majority = 14,
        .smoothing = true,
        .passage = 3.25,
        .onlyVisible = true,
        .box = GrowBox{{95.0, -48.0, 28.0}, {99.0, -40.0, 20.0}},
        .overwriteUnlocked = true};
}

} // namespace

class GrowLimitsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnUnexpectedMessages(); }

    void nothingAskedIsNoLimit() { QCOMPARE(limitsOf({.lower = 0.0, .upper = 1.0}), GrowLimits()); }

    void differencesAreCountedInCodesByExactSearch()
    {
        QCOMPARE(*limitsOf({.difference = 1.0}).difference, 4);
        QCOMPARE(*limitsOf({.difference = 0.999}).difference, 3);
        QCOMPARE(*limitsOf({.difference = 0.0}).difference, 0);
        QCOMPARE(*limitsOf({.difference = 1e300}).difference, 65535);
        Volume downwards = smallVolume();
        downwards.encoding.rescaleSlope = -0.1;
        downwards.encoding.storedStep = -1;
        QCOMPARE(*limitsOf({.difference = 0.3}, downwards).difference,
            0.1 * 3.0 <= 0.3 ? 3 : 2); // as doubles multiply
    }

    /// A plane that rises by g units a millimetre along an axis has just that gradient, whatever
    /// the spacing.
    void gradientsAreAMillimetre()
    {
        const Volume volume = smallVolume();
        const glm::dvec3 spacing = volume.geometry.spacingMm();
        for (const double rise : {0.5, 3.0, 25.0, 140.0}) {
            for (int axis = 0; axis < 3; ++axis) {
                const double codes = 2.0 * rise * spacing[axis] / 0.25; // over two voxels
                if (codes != std::floor(codes))
                    continue;
                const GrowLimits limits = limitsOf({.gradient = rise});
                const int magnitude =
                    int(limits.gradientWeights[axis] * std::int64_t(codes) / 1024);
                const int few = std::max(1, *limits.gradient / 100);
                QVERIFY2(std::abs(magnitude - *limits.gradient) <= few,
                    qPrintable(QStringLiteral("axis %1: %2, not %3")
                                   .arg(axis)
                                   .arg(magnitude)
                                   .arg(*limits.gradient)));
            }
        }
    }

    void gradientsAreFineWhereValuesSpanLittle()
    {
        Volume narrow = smallVolume();
        narrow.maximum = narrow.minimum + 25.0; // 100 codes
        const GradientScale fine = gradientScale(narrow);
        QVERIFY(fine.perUnit > 4.0 * gradientScale(smallVolume()).perUnit);
        Volume wide = smallVolume();
        wide.maximum = 1e6;
        for (const Volume& volume : {narrow, wide, smallVolume()}) {
            const int range =
                std::max(greatestDifference(volume.encoding, volume.maximum - volume.minimum), 1);
            const glm::ivec3 weights = gradientScale(volume).weights;
            for (int axis = 0; axis < 3; ++axis) {
                QVERIFY(weights[axis] > 0 && weights[axis] <= 65535);
                // Nothing in the volume reaches the limit of 32767 and is cut off there.
                QVERIFY(std::int64_t(weights[axis]) * range / 1024 <= 32767 + 32);
            }
        }
        Volume flat = smallVolume();
        flat.maximum = flat.minimum;
        QVERIFY(isSound(limitsOf({.gradient = 1e300, .gradientDifference = 0.0}, flat)));
    }

    void boxesHoldTheNearestVoxels()
    {
        // Corners in any order; i and k run against x and z.
        for (const GrowBox& box : {GrowBox{{100 - 0.5 * 3.4, -50 + 2.4, 30 - 2 * 1.4},
                                       {100 - 0.5 * 7.6, -50 + 4.6, 30 - 2 * 4.4}},
                 GrowBox{{100 - 0.5 * 7.6, -50 + 2.4, 30 - 2 * 4.4},
                     {100 - 0.5 * 3.4, -50 + 4.6, 30 - 2 * 1.4}}}) {
            const GrowLimits limits = limitsOf({.box = box});
            QVERIFY(limits.boxed);
            QVERIFY(limits.boxFrom == glm::ivec3(3, 2, 1));
            QVERIFY(limits.boxTo == glm::ivec3(8, 5, 4));
        }
        const GrowLimits clipped = limitsOf({.box = GrowBox{{-1e5, -1e5, -1e5}, {1e5, 1e5, 1e5}}});
        QVERIFY(clipped.boxFrom == glm::ivec3(0));
        QVERIFY(clipped.boxTo == glm::ivec3(19, 15, 9));
    }

    void aBoxOutsideTheVolumeIsRefused()
    {
        const Document document = initialDocument(smallVolume());
        GrowSteps grow;
        grow.criteria.box = GrowBox{{101.0, -50.0, 30.0}, {200.0, -40.0, 20.0}};
        const Result<GrowBurst> burst = growBurst(grow, document);
        QVERIFY(!burst);
        QCOMPARE(burst.error().code, ErrorCode::InvalidField);
        QCOMPARE(burst.error().arguments.value(0), QStringLiteral("grow.box"));
    }

    void theBurstHasThem()
    {
        const Document document = initialDocument(smallVolume());
        const Result<GrowBurst> burst = growBurst(GrowSteps{.criteria = everything()}, document);
        QVERIFY(burst);
        QVERIFY(isSound(burst->limits));
        QCOMPARE(burst->limits, limitsOf(everything()));
        QCOMPARE(*burst->limits.difference, 50);
        QCOMPARE(burst->limits.majority, 14);
        QCOMPARE(burst->limits.sigmas256, 640);
        QVERIFY(burst->limits.onlyVisible && burst->limits.gradient
            && burst->limits.gradientDifference);
        QVERIFY(burst->limits.smoothed);
    }

    void recipesNameThem()
    {
        const Edit edit = quantised(GrowSteps{.criteria = everything(), .steps = 7});
        const QJsonObject json = editToJson(edit);
        for (const char* name : {"sigmas", "difference", "gradient", "gradientDifference",
                 "majority", "smoothing", "passage", "onlyVisible", "box"})
            QVERIFY2(json.contains(QLatin1String(name)), name);
        const Result<Edit> read = editFromJson(json);
        QVERIFY(read);
        QCOMPARE(read->get<GrowSteps>().criteria, edit.get<GrowSteps>().criteria);
        for (const auto& [field, value] : {std::pair{"majority", QJsonValue(28)},
                 std::pair{"majority", QJsonValue(0)}, std::pair{"sigmas", QJsonValue(0)},
                 std::pair{"smoothing", QJsonValue(1)}, std::pair{"passage", QJsonValue(-0.5)},
                 std::pair{"difference", QJsonValue(-1)}, std::pair{"gradient", QJsonValue(-0.5)},
                 std::pair{"box", QJsonValue(QStringLiteral("none"))}}) {
            QJsonObject wrong = json;
            wrong[QLatin1String(field)] = value;
            const Result<Edit> refused = editFromJson(wrong);
            QVERIFY2(!refused, field);
            QCOMPARE(
                refused.error().arguments.value(0), QStringLiteral("grow.") + QLatin1String(field));
        }
    }

    /// Rows from before keep their form, and with it their hashes.
    void smoothingIsToldWhereItIsSet()
    {
        const auto named = [](const GrowCriteria& criteria) {
            return editToJson(GrowSteps{.criteria = criteria}).value(QLatin1String("smoothing"));
        };
        QVERIFY(named({.lower = 0.0, .upper = 1.0}).isUndefined());
        QCOMPARE(named({.smoothing = true}), QJsonValue(true));
        QCOMPARE(named({.smoothing = false}), QJsonValue(false));
        QCOMPARE(limitsOf({.smoothing = false}), GrowLimits());
        QCOMPARE(limitsOf({.smoothing = true}), GrowLimits{.smoothed = true});
    }

    /// Another interval follows the growth that is there; a tolerance is of the voxels' own values.
    void smoothingDoesNotDependOnTheInterval()
    {
        Document document = initialDocument(smallVolume());
        ChangeInterval change{
            .criteria = {.lower = 0.0, .upper = 1.0, .smoothing = true}, .asBefore = false};
        Edit edit = change;
        QVERIFY(nameWhatGrowthReads(edit, History(), document));
        const Result<GrowBurst> burst = growBurst(edit.get<ChangeInterval>(), document);
        QVERIFY(burst && burst->limits.smoothed);
        QVERIFY(burst->opening == GrowOpening::Narrow);
        document.segments.push_back({.label = 1});
        QVERIFY(toleranceRule(1, {.smoothing = false}, document));
        const Result<ToleranceRule> refused = toleranceRule(1, {.smoothing = true}, document);
        QVERIFY(!refused);
        QCOMPARE(refused.error().arguments.value(0), QStringLiteral("tolerance.smoothing"));
    }

    /// Half a millimetre is the finest spacing here.
    void passagesAreCountedInSixteenthsOfAVoxel()
    {
        const VolumeGeometry geometry = smallVolume().geometry;
        QCOMPARE(leastPassageMm(geometry), 1.0);
        QCOMPARE(greatestPassageMm(geometry), 15.5);
        const Passage passage = passageOf(3.0, geometry);
        QVERIFY(passage.spacing == glm::ivec3(16, 32, 64));
        QCOMPARE(passage.reach, 48 * 48);
        QVERIFY(reachOf(passage) == glm::ivec3(3, 1, 0));
        QCOMPARE(passageOf(15.5, geometry).reach, 248 * 248);
        // A ball of only its centre asks nothing, whatever its width.
        QCOMPARE(passageOf(0.0, geometry), Passage());
        QCOMPARE(passageOf(0.99, geometry), Passage());
        QVERIFY(isAsked(passageOf(1.0, geometry)));
        Volume volume = smallVolume();
        for (double spacing = 0.11; spacing < 3.0; spacing *= 1.37) {
            for (int axis = 0; axis < 3; ++axis)
                volume.geometry.indexToWorld[axis] =
                    glm::dvec4(0.0, 0.0, 0.0, 0.0) + spacing * glm::dmat4(1.0)[axis];
            for (int voxels = 1; voxels <= greatestPassageReach; ++voxels) {
                const GrowLimits limits = limitsOf({.passage = 2.0 * voxels * spacing}, volume);
                QVERIFY(isSound(limits));
                QVERIFY(reachOf(limits.passage) == glm::ivec3(voxels));
            }
            QVERIFY(isSound(limitsOf({.passage = greatestPassageMm(volume.geometry)}, volume)));
        }
    }

    void aPassageThatIsTooWideIsRefused()
    {
        const Document document = initialDocument(smallVolume());
        GrowSteps grow;
        grow.criteria.passage = 15.6;
        const Result<GrowBurst> burst = growBurst(grow, document);
        QVERIFY(!burst);
        QCOMPARE(burst.error().arguments.value(0), QStringLiteral("grow.passage"));
        QVERIFY2(burst.error().arguments.value(1).contains(QStringLiteral("15.5")),
            qPrintable(burst.error().arguments.value(1)));
        // It has to be told what the segment held.
        grow.criteria.passage = 5.0;
        QVERIFY(growBurst(grow, document));
        grow.tellsHeld = false;
        QVERIFY(!growBurst(grow, document));
    }

    /// Another interval begins at the seeds; a tolerance is not known.
    void aPassageDependsOnTheInterval()
    {
        const Document document = initialDocument(smallVolume());
        ChangeInterval change{
            .criteria = {.lower = 0.0, .upper = 1.0, .passage = 5.0}, .asBefore = false};
        for (const auto& [width, opens] :
            {std::pair{5.0, GrowOpening::Restart}, std::pair{0.5, GrowOpening::Narrow}}) {
            change.criteria.passage = width;
            Edit edit = change;
            QVERIFY(nameWhatGrowthReads(edit, History(), document));
            const Result<GrowBurst> burst = growBurst(edit.get<ChangeInterval>(), document);
            QVERIFY(burst);
            QVERIFY(burst->opening == opens);
        }
        change.criteria.passage = 5.0;
        change.fromSeeds = false;
        const Result<GrowBurst> narrowed = growBurst(change, document);
        QVERIFY(!narrowed);
        QCOMPARE(narrowed.error().arguments.value(0), QStringLiteral("interval.fromSeeds"));
    }

    void whatIsCarvedMattersWhereOnlyTheVisibleGrows()
    {
        const Document document = initialDocument(smallVolume());
        GrowSteps grow{.criteria = everything()};
        const BrickKey coverage{Field::Coverage, 3, 0};
        QVERIFY(RowDependencies(grow, document, {}).covers(coverage));
        QVERIFY(RowDependencies(grow, document, {}).covers({Field::Labels, 0, 0}));
        grow.criteria.onlyVisible = false;
        QVERIFY(!RowDependencies(grow, document, {}).covers(coverage));
        QVERIFY(RowDependencies(grow, document, {}).covers({Field::Labels, 0, 0}));
    }
};

BURIN_TEST(GrowLimitsTest)

} // namespace growLimitsTest

#include "GrowLimitsTest.moc"
