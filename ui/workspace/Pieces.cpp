// SPDX-License-Identifier: Apache-2.0
#include "ui/workspace/Pieces.h"

#include "core/edits/kinds/history/ReviseStroke.h"
#include "core/edits/kinds/layers/AddLayer.h"
#include "core/edits/kinds/layers/RemoveLayer.h"
#include "core/edits/kinds/pieces/ChangePiece.h"
#include "core/edits/kinds/pieces/CutPiece.h"
#include "core/edits/kinds/pieces/PastePiece.h"
#include "core/edits/kinds/pieces/RemovePiece.h"
#include "core/edits/kinds/pieces/SendPiecesHome.h"
#include "core/history/StandingStrokes.h"
#include "core/session/questions/VoxelQuestions.h"
#include "ui/base/NumberText.h"
#include "ui/base/RowTitleText.h"
#include "ui/base/StudyTexts.h"
#include "ui/workspace/LayerActions.h"
#include "ui/workspace/LayerLooks.h"
#include "ui/workspace/OpeningView.h"
#include "ui/workspace/Workspace.h"

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

/// "Lid 2" or so: the first such name that is free.
QString freeName(const core::Document& document, const QString& pattern)
{
    for (int number = 1;; ++number) {
        const QString name = pattern.arg(number);
        const bool taken = std::any_of(document.pieces.begin(), document.pieces.end(),
            [&name](const core::Piece& piece) { return piece.name == name; });
        if (!taken)
            return name;
    }
}

} // namespace

Pieces::Pieces(Workspace& workspace)
    : QObject(&workspace)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        m_measuring.cancel();
        m_looks.clear();
        m_held = 0;
        m_active = 0;
        follow();
        Q_EMIT looksChanged();
        Q_EMIT activeChanged();
    });
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::Pieces
                || change.what == core::DocumentChange::What::Segments)
                follow();
        });
}

void Pieces::follow()
{
    const core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    const core::Document& document = session->document();
    if (m_held != 0 && !document.piece(m_held))
        m_held = 0;
    if (!document.piece(m_active))
        setActive(document.pieces.empty() ? 0 : document.pieces.back().id);
}

PieceLook Pieces::look(int piece) const
{
    const auto found = m_looks.find(piece);
    return found == m_looks.end() ? PieceLook() : found->second;
}

void Pieces::setLook(int piece, const PieceLook& look)
{
    if (look == this->look(piece))
        return;
    m_looks[piece] = look;
    Q_EMIT looksChanged();
}

void Pieces::setActive(int piece)
{
    if (piece == m_active)
        return;
    m_active = piece;
    Q_EMIT activeChanged();
}

core::PiecePose Pieces::pose(const core::Piece& piece) const
{
    return piece.id == m_held ? m_heldPose : piece.pose;
}

void Pieces::hold(int piece, const core::PiecePose& pose)
{
    if (m_held == piece && m_heldPose == pose)
        return;
    m_held = piece;
    m_heldPose = pose;
    Q_EMIT looksChanged();
}

void Pieces::letGo(bool keep)
{
    if (m_held == 0)
        return;
    const int piece = std::exchange(m_held, 0);
    if (keep)
        setPose(piece, m_heldPose);
    Q_EMIT looksChanged();
}

void Pieces::setPose(int piece, const core::PiecePose& pose)
{
    if (!m_workspace.session())
        return;
    core::ChangePiece edit;
    edit.piece = piece;
    edit.offsetMm = pose.offsetMm;
    edit.rotationDegrees = pose.rotationDegrees;
    edit.zoom = std::clamp(pose.zoom, 0.125, 16.0);
    apply(edit);
}

void Pieces::apply(const core::ChangePiece& edit)
{
    if (const auto applied = m_workspace.session()->apply(edit); !applied)
        m_workspace.fail(applied.error());
}

void Pieces::sendHome()
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    if (const auto applied = session->apply(core::SendPiecesHome{}); !applied)
        m_workspace.fail(applied.error());
}

bool Pieces::allHome() const
{
    const core::EditSession* session = m_workspace.session();
    return !session
        || std::all_of(session->document().pieces.begin(), session->document().pieces.end(),
            [](const core::Piece& piece) { return piece.pose.isHome(); });
}

void Pieces::measure(int layer, int segment, std::function<void(const PieceExtent&)> then,
    std::function<void()> unless)
{
    if (!unless)
        unless = [] {};
    const core::VolumeGeometry geometry = m_workspace.volume()->geometry;
    const core::BrickGrid grid{geometry.size};
    std::vector<core::BrickKey> keys;
    keys.reserve(std::size_t(grid.brickCount()));
    const core::Segment* its = m_workspace.session()->document().segment(segment);
    const std::uint8_t plane = layer > 0 ? std::uint8_t(layer) : its ? its->plane : std::uint8_t(0);
    for (int brick = 0; brick < grid.brickCount(); ++brick)
        keys.push_back({.field = layer > 0 ? core::Field::Coverage : core::Field::Labels,
            .plane = plane,
            .brick = std::uint32_t(brick)});
    const auto fail = [this, unless](const core::Error& error) {
        m_workspace.fail(error);
        unless();
    };
    auto take = [this, geometry, segment, then = std::move(then), unless, fail](
                    core::Result<std::vector<core::BrickImage>> answer) {
        if (!answer)
            return fail(answer.error());
        m_measuring.start(
            this,
            [bricks = *std::move(answer), geometry, segment] {
                return extentOf(bricks, geometry, segment);
            },
            [this, then, unless, fail](const core::Result<PieceExtent>& extent) {
                if (!extent)
                    return fail(extent.error());
                if (!m_workspace.session())
                    return;
                if (!extent->pointsLps.empty())
                    return then(*extent);
                m_workspace.say(tr("There is nothing in it yet"));
                unless();
            });
    };
    m_workspace.session()->questions().bricks(std::move(keys), std::move(take));
}

void Pieces::cutPiece(
    int layer, const QString& name, std::function<void()> then, std::function<void()> unless)
{
    measure(
        layer, 0,
        [this, layer, name, then = std::move(then), unless](const PieceExtent& extent) {
            core::EditSession& open = *m_workspace.session();
            core::CutPiece edit;
            edit.layer = layer;
            edit.name = name;
            edit.pivotLps = extent.middleLps;
            if (const auto lifted = open.apply(edit); !lifted) {
                m_workspace.fail(lifted.error());
                if (unless)
                    unless();
                return;
            }
            // An undo that waits before it may leave no such layer; it is refused in its turn then.
            const core::Document expected = open.foreseenDocument();
            if (const core::Piece* piece = expected.pieceOfLayer(layer)) {
                setLook(piece->id, {}); // not that of an undone one, whose number it takes
                setActive(piece->id);
                then();
            }
        },
        unless);
}

void Pieces::lift(int layer)
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    const QString name = freeName(session->foreseenDocument(), tr("Piece %1"));
    cutPiece(layer, name, [this, layer, name] {
        const core::SculptLayer* lifted = m_workspace.session()->document().layer(layer);
        const QString layerName = lifted ? lifted->name : QString();
        // What is carved from now on is not to join the piece.
        if (m_workspace.activeLayer() == layer) {
            if (const auto added = addLayer(m_workspace); !added)
                return m_workspace.fail(added.error());
        }
        m_workspace.say(tr("%1 is all that '%2' has carved; it can be moved: tool Pieces, or the "
                           "panel's numbers")
                            .arg(name, layerName));
    });
}

void Pieces::liftLast(int layer)
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    session->closeOpen();
    // Which cut is the last one is known when everything that waits is done.
    session->questions().bricks({}, [this, layer](const auto& answer) {
        if (!answer)
            return m_workspace.fail(answer.error());
        const core::RowId cut = lastCut(layer);
        if (cut != 0)
            liftCut(cut);
        else
            lift(layer);
    });
}

bool Pieces::canLift(core::RowId cut) const
{
    const core::EditSession* session = m_workspace.session();
    if (!session || !core::canBeTaken(session->history(), cut))
        return false;
    const auto strokes = core::standingStrokes(session->history(), session->history().position());
    const auto stroke = std::find_if(strokes.begin(), strokes.end(),
        [cut](const core::StandingStroke& each) { return each.row == cut; });
    return !session->document().pieceOfLayer(core::layerOf(stroke->form));
}

core::RowId Pieces::lastCut(int layer) const
{
    const core::EditSession* session = m_workspace.session();
    if (!session || session->document().pieceOfLayer(layer))
        return 0;
    return core::lastPartialCut(session->history(), layer);
}

void Pieces::liftCut(core::RowId cut)
{
    if (!canLift(cut))
        return m_workspace.say(tr("This cut cannot be told from the rest of its layer"));
    core::EditSession& session = *m_workspace.session();
    const core::History& history = session.history();
    // It keeps what earlier revisions have made of it.
    core::ReviseStroke revise{.row = cut};
    for (const core::RowId row : history.standing()) {
        const auto* earlier = history.row(row).edit.as<core::ReviseStroke>();
        if (earlier && earlier->row == cut)
            revise = *earlier;
    }
    const QString name = freeName(session.foreseenDocument(), tr("Piece %1"));
    if (const auto added = session.apply(core::AddLayer{.name = name}); !added)
        return m_workspace.fail(added.error());
    const int layer = session.foreseenDocument().layers.back().id;
    m_workspace.layerLooks().setLook(layer, {});
    revise.layer = layer;
    if (const auto revised = session.apply(revise); !revised) {
        m_workspace.fail(revised.error());
        return withdraw(layer);
    }
    cutPiece(
        layer, name,
        [this, name, cutName = nameOf(history.row(cut))] {
            m_workspace.say(
                tr("%1 is what '%2' has cut; it can be moved: tool Pieces, or the panel's numbers")
                    .arg(name, cutName));
        },
        [this, layer] { withdraw(layer); });
}

void Pieces::withdraw(int layer)
{
    core::EditSession* asked = m_workspace.session();
    if (!asked)
        return;
    asked->questions().bricks({}, [this, layer, asked](const auto& answer) {
        // It may have been closed, or gone back, since.
        if (!answer || m_workspace.session() != asked || !asked->document().layer(layer))
            return;
        if (!asked->idle()) // the user is at work, which must not be taken from under the hand
            return m_workspace.say(tr("What could not be lifted has a layer of its own now"));
        core::EditSession& session = *asked;
        const core::History& history = session.history();
        const std::vector<core::RowId> rows = history.standing();
        const auto moved = std::find_if(rows.begin(), rows.end(), [&](core::RowId row) {
            const auto* revise = history.row(row).edit.as<core::ReviseStroke>();
            return revise && revise->layer == layer;
        });
        core::RowId last = history.position();
        if (moved != rows.end() && *moved == last)
            last = history.row(last).parent;
        const bool isLast = last != 0 && history.row(last).edit.is<core::AddLayer>()
            && session.document().layers.back().id == layer;
        core::Result<void> gone;
        if (isLast)
            gone = session.goTo(history.row(last).parent);
        else if (moved == rows.end()) // other steps came on top, which are the user's
            gone = session.apply(core::RemoveLayer{.layer = layer});
        if (!gone)
            m_workspace.fail(gone.error());
    });
}

void Pieces::paste(int segment)
{
    const glm::dvec3 rightLps(1, 0, 0);
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    measure(0, segment, [this, segment, rightLps](const PieceExtent& extent) {
        core::EditSession& open = *m_workspace.session();
        const core::VolumeGeometry& geometry = m_workspace.volume()->geometry;
        const core::Segment* known = open.document().segment(segment);
        if (!known)
            return;
        core::PastePiece edit;
        edit.segment = segment;
        edit.name = known->name;
        edit.pivotLps = extent.middleLps;
        // Beside all of the volume.
        double reach = 0.0;
        for (const glm::dvec3& corner : geometry.cornersLps())
            reach = std::max(reach, glm::dot(corner - extent.middleLps, rightLps));
        edit.pose.offsetMm =
            rightLps * std::round(reach * 0.8 + glm::dot(extent.sizeLps, glm::abs(rightLps)) / 2.0);
        const std::size_t before = open.foreseenDocument().pieces.size();
        if (const auto pasted = open.apply(edit); !pasted)
            return m_workspace.fail(pasted.error());
        // None, if an undo that waits before it leaves no such segment.
        if (const core::Document expected = open.foreseenDocument();
            expected.pieces.size() > before) {
            setLook(expected.pieces.back().id, {});
            setActive(expected.pieces.back().id);
        }
    });
}

void Pieces::remove(int piece)
{
    core::EditSession* session = m_workspace.session();
    if (!session)
        return;
    if (const auto removed = session->apply(core::RemovePiece{.piece = piece}); !removed)
        m_workspace.fail(removed.error());
}

void Pieces::openLikeALid(int piece, const glm::dvec3& upLps)
{
    core::EditSession* session = m_workspace.session();
    const core::Piece* known = session ? session->document().piece(piece) : nullptr;
    if (!known)
        return;
    measure(known->layer, known->segment, [this, piece, upLps](const PieceExtent& extent) {
        const core::Piece* lid = m_workspace.session()->document().piece(piece);
        if (!lid)
            return;
        setPose(piece, lidPose(*lid, extent, m_workspace.volume()->geometry, upLps));
    });
}

std::vector<gpu::ScenePiece> Pieces::scene() const
{
    std::vector<gpu::ScenePiece> result;
    const core::EditSession* session = m_workspace.session();
    if (!session || !m_workspace.volume())
        return result;
    const core::Document& document = session->document();
    for (const core::Piece& piece : document.pieces) {
        const PieceLook look = this->look(piece.id);
        core::Piece shown = piece;
        shown.pose = pose(piece);
        gpu::ScenePiece drawn = scenePiece(shown, document);
        drawn.opacity = look.visible ? float(look.opacity) : 0.0f;
        drawn.solid = drawn.solid && !look.tissue;
        drawn.rgb = look.rgb.value_or(drawn.solid ? drawn.rgb : 0xFFFFFFU);
        drawn.transferFunction = look.map;
        result.push_back(drawn);
    }
    return result;
}

QString Pieces::badge(const core::PiecePose& pose)
{
    QStringList parts;
    if (const double mm = glm::length(pose.offsetMm); mm >= 0.05)
        parts += tr("%1 mm").arg(numberText(mm, mm < 10.0 ? 1 : 0));
    if (const double degrees = glm::length(pose.rotationDegrees); degrees >= 0.5)
        parts += tr("%1°").arg(numberText(degrees, 0));
    if (std::abs(pose.zoom - 1.0) > 1e-6)
        parts += tr("%1×").arg(QString::number(pose.zoom, 'g', 3));
    return parts.join(QStringLiteral(" · "));
}

} // namespace ui
