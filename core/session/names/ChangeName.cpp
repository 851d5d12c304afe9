// SPDX-License-Identifier: Apache-2.0
#include "core/session/names/ChangeName.h"

#include "core/edits/answers/RowWords.h"
#include "core/edits/kinds/layers/ChangeLayer.h"
#include "core/edits/kinds/pieces/ChangePiece.h"
#include "core/edits/kinds/segments/ChangeSegment.h"

#include <QStringList>

#include <cmath>
#include <optional>

namespace core {

using namespace rowWords;

namespace {

/// What was done, one after the other; the first says to what.
class Deeds {
public:
    /// @param alone "Lock segment 'A'", @param further "lock it"
    void add(const QString& alone, const QString& further)
    {
        m_deeds += m_deeds.isEmpty() ? alone : further;
    }
    [[nodiscard]] QString text() const { return m_deeds.join(QStringLiteral(", ")); }

private:
    QStringList m_deeds;
};

template <class T> bool differs(const std::optional<T>& value, const T* before)
{
    return value && (!before || *before != *value);
}

} // namespace

QString changeName(const ChangeSegment& edit, const Document& document)
{
    const Segment* before = document.segment(edit.segment);
    const QString name = quoted(segmentName(edit.segment, document));
    Deeds deeds;
    if (differs(edit.name, before ? &before->name : nullptr))
        deeds.add(
            QStringLiteral("Rename segment %1 to %2").arg(edit.segment).arg(quoted(*edit.name)),
            {});
    if (differs(edit.code, before ? &before->code : nullptr)) {
        if (edit.code->isSet())
            deeds.add(QStringLiteral("Code segment %1 as %2").arg(name, edit.code->meaning),
                QStringLiteral("code it as ") + edit.code->meaning);
        else
            deeds.add(QStringLiteral("Take the code from segment ") + name,
                QStringLiteral("take its code away"));
    }
    if (differs(edit.rgb, before ? &before->rgb : nullptr))
        deeds.add(QStringLiteral("Recolour segment ") + name, QStringLiteral("recolour it"));
    if (differs(edit.locked, before ? &before->locked : nullptr)) {
        if (*edit.locked)
            deeds.add(QStringLiteral("Lock segment ") + name, QStringLiteral("lock it"));
        else
            deeds.add(QStringLiteral("Unlock segment ") + name, QStringLiteral("unlock it"));
    }
    if (differs(edit.uncarvable, before ? &before->uncarvable : nullptr)) {
        if (*edit.uncarvable)
            deeds.add(QStringLiteral("Protect segment %1 from sculpting").arg(name),
                QStringLiteral("protect it from sculpting"));
        else
            deeds.add(QStringLiteral("Let tools carve segment ") + name,
                QStringLiteral("let tools carve it"));
    }
    return deeds.text();
}

QString changeName(const ChangeLayer& edit, const Document& document)
{
    const SculptLayer* before = document.layer(edit.layer);
    const QString name = layerName(edit.layer, document);
    Deeds deeds;
    if (differs(edit.name, before ? &before->name : nullptr))
        deeds.add(QStringLiteral("Rename layer %1 to %2").arg(name, quoted(*edit.name)), {});
    if (differs(edit.solo, before ? &before->solo : nullptr)) {
        if (*edit.solo)
            deeds.add(QStringLiteral("Solo layer ") + name, QStringLiteral("solo it"));
        else
            deeds.add(QStringLiteral("End solo of layer ") + name, QStringLiteral("end its solo"));
    }
    if (differs(edit.muted, before ? &before->muted : nullptr)) {
        if (*edit.muted)
            deeds.add(QStringLiteral("Mute layer ") + name, QStringLiteral("mute it"));
        else
            deeds.add(QStringLiteral("Unmute layer ") + name, QStringLiteral("unmute it"));
    }
    return deeds.text();
}

QString changeName(const ChangePiece& edit, const Document& document)
{
    const Piece* piece = document.piece(edit.piece);
    const QString name = pieceName(edit.piece, document);
    Deeds deeds;
    if (differs(edit.name, piece ? &piece->name : nullptr))
        deeds.add(QStringLiteral("Rename piece %1 to %2").arg(name, quoted(*edit.name)), {});
    const PiecePose before = piece ? piece->pose : PiecePose();
    const PiecePose pose{.offsetMm = edit.offsetMm.value_or(before.offsetMm),
        .rotationDegrees = edit.rotationDegrees.value_or(before.rotationDegrees),
        .zoom = edit.zoom.value_or(before.zoom)};
    if (pose == before)
        return deeds.text();
    if (pose.isHome()) {
        deeds.add(QStringLiteral("Send piece %1 home").arg(name), QStringLiteral("send it home"));
        return deeds.text();
    }
    // What it differs in from where it was: that is what the hand did.
    if (pose.offsetMm != before.offsetMm) {
        const QString far = millimetres(glm::length(pose.offsetMm));
        deeds.add(
            QStringLiteral("Move piece %1 %2").arg(name, far), QStringLiteral("move it ") + far);
    }
    if (pose.rotationDegrees != before.rotationDegrees) {
        const QString angle =
            QString::number(std::lround(glm::length(pose.rotationDegrees))) + QStringLiteral("°");
        deeds.add(QStringLiteral("Turn piece %1 %2").arg(name, angle),
            QStringLiteral("turn it ") + angle);
    }
    if (pose.zoom != before.zoom) {
        const QString factor = QString::number(pose.zoom, 'g', 3) + QStringLiteral("×");
        deeds.add(QStringLiteral("Zoom piece %1 %2").arg(name, factor),
            QStringLiteral("zoom it ") + factor);
    }
    return deeds.text();
}

} // namespace core
