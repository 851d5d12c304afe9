// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/RandomRepair.h"

#include "core/edits/EditJson.h"
#include "core/edits/kinds/chunks/ChunkToggle.h"
#include "core/edits/kinds/chunks/DivideSegment.h"
#include "core/edits/kinds/surface/ApplyTemplate.h"
#include "core/edits/kinds/surface/AttractSurface.h"
#include "core/edits/kinds/surface/ChangeMarks.h"
#include "core/edits/kinds/surface/DropSurface.h"
#include "core/edits/kinds/surface/FollowMask.h"
#include "core/edits/kinds/surface/LaySurface.h"
#include "core/edits/kinds/surface/MarkSurface.h"
#include "core/edits/kinds/surface/PlaneScrape.h"
#include "core/edits/kinds/surface/PointDrag.h"
#include "core/edits/kinds/surface/SmoothSurface.h"
#include "core/edits/kinds/surface/SpherePush.h"
#include "core/edits/kinds/surface/SurfaceBarrier.h"
#include "core/edits/kinds/surface/WriteBack.h"
#include "core/refine/mesh/SimplexMesh.h"
#include "core/session/EditSession.h"
#include "core/session/SessionSurface.h"
#include "tests/reference/ReferenceEngine.h"
#include "tests/support/cases/SurfaceCases.h"
#include "tests/support/scenes/PlainEdits.h"
#include "tests/support/scenes/SmallStudy.h"

#include <QTemporaryDir>

#include <cmath>
#include <memory>
#include <random>
#include <set>
#include <vector>

namespace test {

using namespace core;

namespace {

constexpr double ballVoxels = 9.0;
constexpr int mostBranches = 3;

/// Somebody who repairs a ball at random: surface, chunks, paint, with undo, redo, jumps, strokes
/// that are given up, templates that are aborted, and closing and opening the file. A place of the
/// history always holds the same, however it was reached.
class HastyRepairer {
public:
    HastyRepairer(EditEngine& engine, std::uint32_t seed)
        : m_random(seed)
        , m_engine(engine)
        , m_session(*EditSession::create(m_engine, smallStudy(), {.file = file()}))
    {
        m_known[0] = m_session->stateHash();
        run(ballMask(geometry().size, ballVoxels));
        run(newSegment(QStringLiteral("Other"), 7));
    }

    /// What is wrong after the first step that went wrong; empty if none did.
    [[nodiscard]] QString work(int commands)
    {
        for (int step = 0; step < commands && m_wrong.isEmpty(); ++step)
            act();
        return m_wrong;
    }
    /// Carries out the newest branches from the beginning.
    [[nodiscard]] QString workAnew()
    {
        const std::vector<HistoryRow>& rows = m_session->history().rows();
        std::set<RowId> parents;
        for (const HistoryRow& row : rows)
            parents.insert(row.parent);
        int branches = 0;
        for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
            if (m_wrong.isEmpty() && parents.count(row->id) == 0 && ++branches <= mostBranches)
                carryOutAnew(row->id);
        }
        return m_wrong;
    }
    [[nodiscard]] const std::map<QString, int>& done() const { return m_done; }

private:
    [[nodiscard]] QString file() const { return m_folder.filePath(QStringLiteral("r.burin")); }
    [[nodiscard]] const VolumeGeometry& geometry() const { return m_study.volume.geometry; }
    int between(int low, int high) { return low + int(m_random() % std::uint32_t(high - low + 1)); }
    bool chance(int percent) { return between(1, 100) <= percent; }

    /// From the middle of the volume, in voxels.
    [[nodiscard]] glm::dvec3 at(const glm::dvec3& off) const
    {
        return geometry().toWorld((glm::dvec3(geometry().size) - 1.0) / 2.0 + off);
    }
    glm::dvec3 direction()
    {
        const double height = between(-100, 100) / 100.0;
        const double turn = between(0, 359) * M_PI / 180.0;
        const double flat = std::sqrt(1.0 - height * height);
        return {flat * std::cos(turn), flat * std::sin(turn), height};
    }
    SurfaceRules rules() { return chance(70) ? SurfaceRules(newestSurfaceRules) : std::nullopt; }

    void check(const QString& what)
    {
        const RowId row = m_session->history().position();
        const QByteArray hash = m_session->stateHash();
        const auto known = m_known.emplace(row, hash).first;
        if (known->second != hash && m_wrong.isEmpty())
            m_wrong = QStringLiteral("row %1 holds something else after: %2").arg(row).arg(what);
    }

    /// Where it is refused nothing has changed.
    void run(const Edit& edit)
    {
        const std::size_t rows = m_session->history().rows().size();
        const RowId before = m_session->history().position();
        const Result<void> asked = m_session->apply(edit);
        const Result<void> done = asked ? m_session->settle() : asked;
        const bool leftRow = m_session->history().rows().size() > rows;
        if (!done && (leftRow || m_session->history().position() != before))
            m_wrong = QStringLiteral("%1 was refused and left a row").arg(editName(edit));
        if (!done && done.error().code == ErrorCode::Internal)
            m_wrong = done.error().arguments.join(u' ');
        if (leftRow)
            ++m_done[editName(edit)];
        check(editName(edit));
    }

    void act()
    {
        const int dice = between(0, 99);
        if (dice < 14) {
            static_cast<void>(m_session->undo());
            settle(QStringLiteral("undo"));
        } else if (dice < 26 && m_session->history().canRedo()) {
            static_cast<void>(m_session->redo());
            settle(QStringLiteral("redo"));
        } else if (dice < 30) {
            const auto rows = int(m_session->history().rows().size());
            static_cast<void>(m_session->goTo(between(2, rows)));
            settle(QStringLiteral("goTo"));
        } else if (dice < 32) {
            reopen();
        } else if (dice < 38) {
            giveUp();
        } else {
            // Of a few thoughts the one that came true least, so that no kind is left to luck.
            Edit edit = think();
            for (int i = 0; i < 3; ++i) {
                Edit other = think();
                if (m_done[editName(other)] < m_done[editName(edit)])
                    edit = std::move(other);
            }
            run(edit);
        }
    }

    void settle(const QString& what)
    {
        static_cast<void>(m_session->settle());
        ++m_done[what];
        check(what);
    }

    void reopen()
    {
        const RowId row = m_session->history().position();
        m_session.reset();
        auto opened = EditSession::open(m_engine, smallStudy(), file());
        if (!opened)
            qFatal("%s", qPrintable(opened.error().arguments.join(u' ')));
        m_session = *std::move(opened);
        static_cast<void>(m_session->settle());
        if (m_session->history().position() != row)
            m_wrong = QStringLiteral("it was opened again elsewhere");
        ++m_done[QStringLiteral("reopen")];
        check(QStringLiteral("reopen"));
    }

    /// A stroke that is taken back, or a template that is aborted while it moves.
    void giveUp()
    {
        const std::size_t rows = m_session->history().rows().size();
        QString what = QStringLiteral("given up");
        if (chance(50) && m_session->begin(lobe())) {
            if (chance(50)) {
                // It may stand already, or have failed; then there is nothing to abort.
                if (m_session->surface().isAbortable())
                    what = QStringLiteral("template aborted");
                m_session->surface().abort();
            } else {
                m_session->end(Ending::Rollback);
            }
        } else {
            SpherePush push = pushAnywhere();
            const std::vector<glm::dvec3> points = push.path.pointsLps;
            push.path.pointsLps.resize(1);
            push.path.pressures.reset();
            if (m_session->begin(push)) {
                m_session->extend(PathPoints{.pointsLps = points});
                m_session->poll();
                m_session->end(Ending::Rollback);
            }
        }
        if (m_session->transactionOpen())
            m_session->end(Ending::Rollback);
        static_cast<void>(m_session->settle());
        if (m_session->history().rows().size() != rows)
            m_wrong = QStringLiteral("what was given up left a row");
        ++m_done[what];
        check(what);
    }

    Edit think()
    {
        // Two numbers only, so that a surface is also laid again as it was.
        const bool hasSurface = m_session->document().surface.has_value();
        if (!hasSurface && chance(40))
            return LaySurface{.segment = 1, .vertices = 250 * between(1, 2), .rules = rules()};
        switch (between(0, hasSurface ? 19 : 5)) {
        case 0:
            return DivideSegment{.segment = between(1, 2), .marginMm = double(between(2, 6))};
        case 1:
        case 2: {
            ChunkToggle toggle{.segment = between(1, 2), .chunks = between(2, 60)};
            toggle.mode = ChunkToggle::Mode(between(0, 2));
            toggle.overwriteUnlocked = chance(30);
            for (int i = between(1, 2); i > 0; --i)
                toggle.pointsLps.push_back(at(double(between(0, 11)) * direction()));
            return toggle;
        }
        case 3:
        case 4:
            return paintAt(between(1, 2), {at(ballVoxels * direction())}, double(between(2, 4)));
        case 5:
            return lockSegment(2, chance(40));
        case 6:
            if (hasSurface && chance(30))
                return LaySurface{.segment = 1, .onlyCrossings = true};
            return LaySurface{.segment = 1, .vertices = 250 * between(1, 2), .rules = rules()};
        case 7:
        case 8:
            return MarkSurface{
                .mark = SurfaceMark(between(0, 2)), .path = pathAt({ballVoxels * direction()})};
        case 9:
            return ChangeMarks{.mark = chance(70) ? SurfaceMark::Red : SurfaceMark::Green,
                .way = ChangeMarks::Way(between(0, 4))};
        case 10:
            return pushAnywhere();
        case 11: {
            const glm::dvec3 out = direction();
            return PlaneScrape{.path = pathAt({(ballVoxels - 1.0) * out}),
                .normalLps = glm::normalize(at(out) - at(glm::dvec3(0.0)))};
        }
        case 12: {
            const glm::dvec3 out = direction();
            return PointDrag{.path = pathAt({ballVoxels * out, (ballVoxels + 2.0) * out})};
        }
        case 13:
            return SmoothSurface{.path = pathAt({ballVoxels * direction()})};
        case 14:
            return AttractSurface{.path = pathAt({ballVoxels * direction()})};
        case 15:
            return lobe();
        case 16:
            return WriteBack{.overwriteUnlocked = chance(30), .rules = rules()};
        case 17:
            return SurfaceBarrier{.erase = chance(30)};
        case 18:
            return FollowMask{.rules = rules()};
        default:
            return chance(30) ? Edit(DropSurface{}) : Edit(pushAnywhere());
        }
    }

    SurfacePath pathAt(const std::vector<glm::dvec3>& offs)
    {
        SurfacePath path{.radiusMm = double(between(3, 5)), .pointsLps = {}, .rules = rules()};
        for (const glm::dvec3& off : offs)
            path.pointsLps.push_back(at(off));
        if (chance(40)) {
            path.pressures.emplace();
            for (std::size_t i = 0; i < path.pointsLps.size(); ++i)
                path.pressures->push_back(between(2, 10) / 10.0);
        }
        return path;
    }
    SpherePush pushAnywhere()
    {
        const glm::dvec3 out = direction();
        return {
            .path = pathAt({(ballVoxels - 2.0) * out, ballVoxels * out, (ballVoxels + 1.0) * out})};
    }
    /// Over what is red, if anything is.
    ApplyTemplate lobe()
    {
        glm::dvec3 out = direction();
        const SimplexMesh* mesh = m_session->surface().mesh();
        for (const VertexId id : mesh ? mesh->vertexIds() : std::vector<VertexId>()) {
            if (mesh->mark(id) != SurfaceMark::Red)
                continue;
            out = glm::normalize(mesh->position(id) - at(glm::dvec3(0.0)));
            break;
        }
        // From here on in LPS.
        const glm::dvec3 beside = glm::normalize(glm::cross(
            out, std::abs(out.x) < 0.7 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0)));
        const glm::dvec3 across = glm::cross(out, beside);
        const glm::dvec3 top = at(glm::dvec3(0.0)) + (ballVoxels + 4.0) * out;
        ApplyTemplate shape{
            .contoursLps = std::vector<std::vector<glm::dvec3>>(2), .rules = rules()};
        for (double away = -5.0; away <= 5.0; away += 0.5) {
            shape.contoursLps[0].push_back(top - 0.12 * away * away * out + away * beside);
            shape.contoursLps[1].push_back(top - 0.12 * away * away * out + away * across);
        }
        return shape;
    }

    /// In a session of its own on the oracle, row after row from the beginning.
    void carryOutAnew(RowId leaf)
    {
        std::vector<RowId> path;
        for (RowId row = leaf; row != 0; row = m_session->history().row(row).parent)
            path.insert(path.begin(), row);
        reference::ReferenceEngine engine;
        const auto session = *EditSession::create(engine, smallStudy(), {.file = {}});
        for (const RowId row : path) {
            const Edit edit = m_session->history().row(row).edit;
            const Result<void> asked = session->apply(edit);
            const Result<void> done = asked ? session->settle() : asked;
            if (done && session->stateHash() == m_known.at(row))
                continue;
            m_wrong = QStringLiteral("row %1 (%2) is another when it is carried out anew")
                          .arg(row)
                          .arg(editName(edit));
            return;
        }
    }

    std::mt19937 m_random;
    LoadedVolume m_study = smallStudy();
    QTemporaryDir m_folder;
    EditEngine& m_engine;
    std::map<RowId, QByteArray> m_known; ///< the state at a row
    std::map<QString, int> m_done;
    QString m_wrong;
    std::unique_ptr<EditSession> m_session; ///< last: it uses all of the above
};

} // namespace

RandomRepair runRandomRepair(EditEngine& engine, int commands, std::uint32_t seed)
{
    HastyRepairer repairer(engine, seed);
    RandomRepair repair{.failure = repairer.work(commands), .done = {}};
    if (repair.failure.isEmpty())
        repair.failure = repairer.workAnew();
    repair.done = repairer.done();
    return repair;
}

} // namespace test
