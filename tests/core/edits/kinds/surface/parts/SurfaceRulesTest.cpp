// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/surface/parts/SurfaceRules.h"
#include "core/edits/EditJson.h"
#include "core/edits/kinds/surface/ApplyTemplate.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/edits/kinds/surface/MarkSurface.h"
#include "core/edits/kinds/surface/PointDrag.h"
#include "core/edits/kinds/surface/WriteBack.h"
#include "core/refine/mesh/SimplexMesh.h"
#include "core/refine/repair/SelfIntersections.h"
#include "core/session/EditSession.h"
#include "core/session/SessionSurface.h"
#include "core/session/questions/VoxelQuestions.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/SurfaceCases.h"
#include "tests/support/faults/FailingLog.h"
#include "tests/support/program/TestProgram.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <cmath>
#include <memory>

namespace surfaceRulesTest {

using namespace core;

namespace {

const VolumeGeometry geometry = test::smallStudy().volume.geometry;

/// From one wall of the ball through the one across from it.
PointDrag dragThrough(SurfaceRules rules)
{
    const glm::dvec3 middle = (glm::dvec3(geometry.size) - 1.0) / 2.0;
    PointDrag drag{.path = {.radiusMm = 4.0, .pointsLps = {}, .rules = rules}};
    for (double x = 9.0; x >= -13.0; x -= 2.0)
        drag.path.pointsLps.push_back(geometry.toWorld(middle + glm::dvec3(x, 0.0, 0.0)));
    return drag;
}

/// A point of the volume, from its middle in voxels.
glm::dvec3 fromMiddle(double x, double y, double z)
{
    return geometry.toWorld((glm::dvec3(geometry.size) - 1.0) / 2.0 + glm::dvec3(x, y, z));
}

/// Makes one side of the ball red.
MarkSurface redTop()
{
    return {.mark = SurfaceMark::Red,
        .path = {.radiusMm = 6.0,
            .pointsLps = {fromMiddle(9.0, 0.0, 0.0)},
            .rules = newestSurfaceRules}};
}

/// A lobe on that side, on two planes that cross.
ApplyTemplate lobeOnTop()
{
    ApplyTemplate shape{
        .contoursLps = std::vector<std::vector<glm::dvec3>>(2), .rules = newestSurfaceRules};
    for (double away = -5.0; away <= 5.0; away += 0.5) {
        const double height = 12.0 - 0.12 * away * away;
        shape.contoursLps[0].push_back(fromMiddle(height, away, 0.0));
        shape.contoursLps[1].push_back(fromMiddle(height, 0.0, away));
    }
    return shape;
}

} // namespace

/// By which rules a surface is moved is a part of the edit that moves it.
class SurfaceRulesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnUnexpectedMessages();
        m_session = *EditSession::create(m_engine, test::smallStudy(), {});
        run(test::ballMask(geometry.size, 9.0));
    }
    void whoNamesNoneWritesNone();
    void eachVersionKeepsItsRules();
    void whatCrossesIsNotWrittenBack();
    void whatCrossesIsLaidAnew();
    void aDragStopsBeforeTheWall();
    void openAndClosedContoursGoTogether();
    void templatesThatSayNothingAreRefused();
    void layingIsAborted();
    void aTemplateIsAborted_data();
    void aTemplateIsAborted();
    void aPreviewThatMovesIsTakenBackSilently();

private:
    void run(const Edit& edit)
    {
        const Result<void> applied = m_session->apply(edit);
        QVERIFY2(applied, qPrintable(applied ? QString() : applied.error().arguments.join(u' ')));
        QVERIFY(m_session->settle());
    }
    [[nodiscard]] std::size_t crossings() const
    {
        return selfIntersections(*m_session->surface().mesh(), geometry).size();
    }

    reference::ReferenceEngine m_engine;
    std::unique_ptr<EditSession> m_session;
};

void SurfaceRulesTest::whoNamesNoneWritesNone()
{
    // Rows and recipes of before keep their bytes, and so their hashes.
    const auto namesThem = [](const Edit& edit) {
        return QJsonDocument(editToJson(edit)).toJson().contains("rules");
    };
    QVERIFY(!namesThem(LaySurface{.segment = 1}));
    QVERIFY(namesThem(LaySurface{.segment = 1, .rules = newestSurfaceRules}));
    QVERIFY(!namesThem(dragThrough({})));
    QVERIFY(namesThem(dragThrough(newestSurfaceRules)));
    QVERIFY(!editToJson(LaySurface{.segment = 1}).contains(QLatin1String("onlyCrossings")));
    const QJsonObject anew = editToJson(LaySurface{.segment = 1, .onlyCrossings = true});
    QVERIFY(anew.value(QLatin1String("onlyCrossings")).toBool());
    QCOMPARE(editToJson(*editFromJson(anew)), anew);
}

/// Rows of before are carried out by the rules that they name, whichever have come since.
void SurfaceRulesTest::eachVersionKeepsItsRules()
{
    for (const SurfaceRules& first : {SurfaceRules(), SurfaceRules(1)})
        QVERIFY(!keepsApart(first) && !laysFiner(first));
    for (const int apart : {2, 3})
        QVERIFY(keepsApart(apart) && !laysFiner(apart));
    for (int finer = 4; finer <= newestSurfaceRules; ++finer)
        QVERIFY(keepsApart(finer) && laysFiner(finer));
}

void SurfaceRulesTest::whatCrossesIsNotWrittenBack()
{
    run(LaySurface{.segment = 1, .vertices = 600});
    run(dragThrough({}));
    QVERIFY(crossings() > 0);
    const QByteArray before = m_session->stateHash();
    const int row = m_session->history().position();
    QVERIFY(m_session->apply(WriteBack{.rules = newestSurfaceRules}));
    const Result<void> written = m_session->settle();
    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::InvalidField);
    QCOMPARE(written.error().arguments,
        QStringList({QString::fromLatin1(crossingSurface), QString::number(crossings())}));
    QCOMPARE(m_session->history().position(), row);
    QCOMPARE(m_session->stateHash(), before);
    run(WriteBack{});
}

/// A surface of a recipe or session of before is written back after all, with what was moved.
void SurfaceRulesTest::whatCrossesIsLaidAnew()
{
    const LaySurface anew{.segment = 1, .onlyCrossings = true};
    const Result<void> asked = m_session->apply(anew);
    const Result<void> refused = asked ? m_session->settle() : asked;
    QVERIFY(!refused); // there is none
    QCOMPARE(refused.error().code, ErrorCode::InvalidField);
    run(LaySurface{.segment = 1, .vertices = 600});
    const std::size_t rows = m_session->history().rows().size();
    run(anew); // nothing crosses
    QCOMPARE(m_session->history().rows().size(), rows);
    run(dragThrough({}));
    QVERIFY(crossings() > 0);
    const QByteArray before = m_session->stateHash();
    const SimplexMesh mesh = *m_session->surface().mesh();
    run(anew);
    QCOMPARE(crossings(), std::size_t(0));
    QVERIFY(checkSimplexMesh(*m_session->surface().mesh()));
    const HistoryRow& row = m_session->history().rows().back();
    QVERIFY2(row.name.startsWith(QStringLiteral("Lay crossing parts of the surface anew, ")),
        qPrintable(row.name));
    const QByteArray after = m_session->stateHash();
    QVERIFY(after != before);
    QVERIFY(m_session->undo());
    QVERIFY(m_session->settle());
    QCOMPARE(m_session->stateHash(), before);
    QVERIFY(identical(*m_session->surface().mesh(), mesh));
    QVERIFY(m_session->redo());
    QVERIFY(m_session->settle());
    QCOMPARE(m_session->stateHash(), after);
    QCOMPARE(crossings(), std::size_t(0));
    // The segment and the surface agree no more, as the dent was not written back yet.
    QVERIFY(m_session->document().surface->differs);
    const std::int64_t held = m_session->document().segment(1)->voxels;
    run(WriteBack{.rules = newestSurfaceRules});
    QVERIFY(m_session->document().segment(1)->voxels < held);
    QVERIFY(m_session->stateHash() != after);
    QVERIFY(!m_session->document().surface->isApart());
}

void SurfaceRulesTest::aDragStopsBeforeTheWall()
{
    run(LaySurface{.segment = 1, .vertices = 600, .rules = newestSurfaceRules});
    run(dragThrough(newestSurfaceRules));
    QCOMPARE(crossings(), std::size_t(0));
    run(WriteBack{.rules = newestSurfaceRules});
}

void SurfaceRulesTest::openAndClosedContoursGoTogether()
{
    const glm::dvec3 middle = (glm::dvec3(geometry.size) - 1.0) / 2.0;
    const auto at = [&](double x, double y, double z) {
        return geometry.toWorld(middle + glm::dvec3(x, y, z));
    };
    run(LaySurface{.segment = 1, .vertices = 600, .rules = newestSurfaceRules});
    run(MarkSurface{.mark = SurfaceMark::Red,
        .path = {.radiusMm = 6.0, .pointsLps = {at(9.0, 0.0, 0.0)}, .rules = newestSurfaceRules}});
    ApplyTemplate shape{.contoursLps = std::vector<std::vector<glm::dvec3>>(3), .rules = 2};
    for (double away = -5.0; away <= 5.0; away += 0.5) {
        const double height = 12.0 - 0.12 * away * away;
        shape.contoursLps[0].push_back(at(height, away, 0.0));
        shape.contoursLps[1].push_back(at(height, 0.0, away));
    }
    for (int i = 0; i <= 24; ++i) {
        const double turn = (i % 24) * M_PI / 12.0;
        shape.contoursLps[2].push_back(at(10.5, 3.54 * std::cos(turn), 3.54 * std::sin(turn)));
    }
    const QByteArray before = m_session->stateHash();
    const Result<void> asked = m_session->apply(shape);
    const Result<void> refused = asked ? m_session->settle() : asked;
    QVERIFY(!refused);
    QVERIFY(refused.error().arguments.value(1).contains(QLatin1String("go together")));
    QCOMPARE(m_session->stateHash(), before);
    shape.rules = newestSurfaceRules;
    run(shape);
    const QByteArray after = m_session->stateHash();
    QVERIFY(after != before);
    QCOMPARE(crossings(), std::size_t(0));
    QVERIFY(m_session->undo());
    QVERIFY(m_session->settle());
    QCOMPARE(m_session->stateHash(), before);
    run(shape);
    QCOMPARE(m_session->stateHash(), after);
}

void SurfaceRulesTest::templatesThatSayNothingAreRefused()
{
    const glm::dvec3 middle = (glm::dvec3(geometry.size) - 1.0) / 2.0;
    const auto at = [&](double x, double y, double z) {
        return geometry.toWorld(middle + glm::dvec3(x, y, z));
    };
    run(LaySurface{.segment = 1, .vertices = 600, .rules = newestSurfaceRules});
    run(MarkSurface{.mark = SurfaceMark::Red,
        .path = {.radiusMm = 6.0, .pointsLps = {at(9.0, 0.0, 0.0)}, .rules = newestSurfaceRules}});
    std::vector<glm::dvec3> arc;
    for (double away = -5.0; away <= 5.0; away += 0.5)
        arc.push_back(at(12.0 - 0.12 * away * away, away, 0.0));
    const QByteArray before = m_session->stateHash();
    const int row = m_session->history().position();
    const std::vector<std::vector<std::vector<glm::dvec3>>> refusedOnes{
        std::vector<std::vector<glm::dvec3>>(501, arc), {{arc[10], arc[10], arc[10]}}};
    for (const auto& contours : refusedOnes) {
        const Result<void> asked =
            m_session->apply(ApplyTemplate{.contoursLps = contours, .rules = newestSurfaceRules});
        const Result<void> refused = asked ? m_session->settle() : asked;
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::InvalidField);
        QCOMPARE(m_session->history().position(), row);
        QCOMPARE(m_session->stateHash(), before);
    }
    // Nobody was asked before.
    run(ApplyTemplate{.contoursLps = refusedOnes[0], .rules = 2});
    QVERIFY(m_session->stateHash() != before);
}

void SurfaceRulesTest::layingIsAborted()
{
    const QByteArray before = m_session->stateHash();
    QVERIFY(!m_session->surface().isAbortable());
    QVERIFY(m_session->apply(LaySurface{.segment = 1, .vertices = 5000}));
    QVERIFY(m_session->surface().isAbortable());
    m_session->surface().abort();
    const Result<void> laid = m_session->settle();
    QVERIFY(!laid);
    QCOMPARE(laid.error().code, ErrorCode::Cancelled);
    QVERIFY(!m_session->surface().isAbortable());
    QCOMPARE(m_session->stateHash(), before);
    QVERIFY(!m_session->document().surface.has_value());
    run(LaySurface{.segment = 1, .vertices = 600});
}

void SurfaceRulesTest::aTemplateIsAborted_data()
{
    QTest::addColumn<bool>("preview");
    QTest::newRow("whole") << false;
    QTest::newRow("preview") << true;
}

void SurfaceRulesTest::aTemplateIsAborted()
{
    QFETCH(bool, preview);
    run(LaySurface{.segment = 1, .vertices = 600, .rules = newestSurfaceRules});
    run(redTop());
    const ApplyTemplate shape = lobeOnTop();
    const QByteArray before = m_session->stateHash();
    const RowId row = m_session->history().position();
    const std::size_t rows = m_session->history().rows().size();
    QVERIFY(!m_session->surface().isAbortable());
    QVERIFY(preview ? m_session->begin(shape) : m_session->apply(shape));
    QVERIFY(m_session->surface().isAbortable());
    m_session->surface().abort();
    QVERIFY(!m_session->isOpen<ApplyTemplate>());
    const Result<void> ended = m_session->settle();
    // Whole, it may have been through before it was told; then it is a row as any other.
    if (!preview && ended) {
        QCOMPARE(m_session->history().rows().size(), rows + 1);
        QVERIFY(m_session->undo());
        QVERIFY(m_session->settle());
    } else {
        QVERIFY(!ended);
        QCOMPARE(ended.error().code, ErrorCode::Cancelled);
        QCOMPARE(m_session->history().rows().size(), rows);
    }
    QVERIFY(!m_session->surface().isAbortable());
    QCOMPARE(m_session->history().position(), row);
    QCOMPARE(m_session->stateHash(), before);
    // And it is as good as new.
    run(shape);
    QVERIFY(m_session->stateHash() != before);
    QVERIFY(!m_session->surface().isAbortable());
}

void SurfaceRulesTest::aPreviewThatMovesIsTakenBackSilently()
{
    run(LaySurface{.segment = 1, .vertices = 600, .rules = newestSurfaceRules});
    run(redTop());
    const QByteArray before = m_session->stateHash();
    QVERIFY(m_session->begin(lobeOnTop()));
    m_session->extend(
        PathPoints{.pointsLps = {{0.0, 0.0, 0.0}}}); // a template has no path: nothing happens
    m_session->end(Ending::Rollback);
    // Who takes it back himself is told nothing.
    QVERIFY(m_session->settle());
    QVERIFY(!m_session->isOpen<ApplyTemplate>());
    QCOMPARE(m_session->stateHash(), before);
}

BURIN_TEST(SurfaceRulesTest)

} // namespace surfaceRulesTest

#include "SurfaceRulesTest.moc"
