// SPDX-License-Identifier: Apache-2.0
#include "ui/models/SegmentListModel.h"

#include "core/edits/kinds/segments/ChangeSegment.h"
#include "core/session/past/FollowedInterval.h"
#include "ui/base/StudyTexts.h"
#include "ui/workspace/ViewSteps.h"
#include "ui/workspace/Workspace.h"

#include <QColor>

#include <algorithm>

namespace ui {

namespace {

/// Empty for an opaque segment.
QString opacityText(const Workspace& workspace, const core::Segment& segment)
{
    const int percent = workspace.segmentOpacity(segment.label);
    return percent < 100 ? SegmentListModel::tr("opacity %1 %").arg(percent) : QString();
}

} // namespace

SegmentListModel::SegmentListModel(Workspace& workspace, QObject* parent)
    : SegmentRows(parent)
    , m_workspace(workspace)
{
    connect(&workspace, &Workspace::sessionChanged, this, [this] {
        clearRows();
        refresh();
    });
    connect(
        &workspace, &Workspace::documentChanged, this, [this](const core::DocumentChange& change) {
            if (change.what == core::DocumentChange::What::Segments
                || change.what == core::DocumentChange::What::Labels
                || change.what == core::DocumentChange::What::Surface)
                refresh();
        });
    connect(&workspace, &Workspace::activeSegmentChanged, this, &SegmentListModel::refresh);
    refresh();
}

void SegmentListModel::refresh()
{
    const core::EditSession* session = m_workspace.session();
    followSegments(session ? &session->document() : nullptr);
    if (!labels().empty())
        Q_EMIT dataChanged(index(0), index(int(labels().size()) - 1));
}

int SegmentListModel::rowOf(int label) const
{
    const auto found = std::find(labels().begin(), labels().end(), label);
    return found == labels().end() ? -1 : int(found - labels().begin());
}

const core::Segment* SegmentListModel::segmentAt(const QModelIndex& index) const
{
    const core::EditSession* session = m_workspace.session();
    if (!session || !checkIndex(index, CheckIndexOption::IndexIsValid))
        return nullptr;
    return session->document().segment(labels()[std::size_t(index.row())]);
}

QString SegmentListModel::followsText(const core::Segment& segment) const
{
    const auto interval = core::followedInterval(segment, m_workspace.session()->history());
    if (!interval)
        return {};
    const core::Volume& volume = *m_workspace.volume();
    const double span = volume.maximum - volume.minimum;
    return tr("follows %1 … %2")
        .arg(valueText(interval->lower.value_or(volume.minimum), {}, span),
            valueText(interval->upper.value_or(volume.maximum), volume.unit, span));
}

QVariant SegmentListModel::data(const QModelIndex& index, int role) const
{
    const core::Segment* segment = segmentAt(index);
    if (!segment)
        return {};
    switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
        return segment->name;
    case Qt::AccessibleTextRole: {
        const QString text = tr("%1, %2, %3")
                                 .arg(segment->name, data(index, VolumeRole).toString(),
                                     segment->visible ? tr("shown") : tr("hidden"));
        QStringList parts{text, opacityText(m_workspace, *segment), followsText(*segment)};
        parts.removeAll(QString());
        return parts.join(QLatin1String(", "));
    }
    case Qt::ToolTipRole: {
        QStringList lines{segment->name, data(index, CodeTextRole).toString()};
        if (const QString follows = followsText(*segment); !follows.isEmpty())
            lines += follows;
        if (const QString opacity = opacityText(m_workspace, *segment); !opacity.isEmpty())
            lines += opacity;
        if (segment->plane > 0)
            lines += tr("overlaps others: plane %1").arg(int(segment->plane) + 1);
        if (data(index, UnwrittenRole).toBool())
            lines += tr("It differs from its surface. Write the surface back, or have the surface "
                        "follow it.");
        return lines.join(QLatin1Char('\n'));
    }
    case LabelRole:
        return int(segment->label);
    case ColourRole:
        return QColor(segment->rgb);
    case VisibleRole:
        return segment->visible;
    case AloneRole:
        return isShownAlone(m_workspace.session()->document(), segment->label);
    case LockedRole:
        return segment->locked;
    case ProtectedRole:
        return segment->uncarvable;
    case VolumeRole:
        return millilitreText(*m_workspace.volume(), segment->voxels);
    case CodeRole:
        return segment->code.isSet()
            ? QStringList{segment->code.scheme, segment->code.value, segment->code.meaning}
            : QStringList();
    case CodeTextRole:
        return segment->code.isSet() ? segment->code.meaning : tr("not coded yet");
    case FollowsRole:
        return followsText(*segment);
    case UnwrittenRole: {
        const auto& surface = m_workspace.session()->document().surface;
        return surface && surface->isApart() && surface->segment == segment->label;
    }
    case ActiveRole:
        return segment->label == m_workspace.activeSegment();
    default:
        return {};
    }
}

bool SegmentListModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    const core::Segment* segment = segmentAt(index);
    if (!segment)
        return false;
    if (role == VisibleRole) {
        m_workspace.viewSteps().showSegment(segment->label, value.toBool());
        return true;
    }
    if (role == AloneRole) {
        m_workspace.viewSteps().showAlone(segment->label);
        return true;
    }
    return change(*segment, value, role);
}

bool SegmentListModel::change(const core::Segment& segment, const QVariant& value, int role)
{
    core::ChangeSegment edit;
    edit.segment = segment.label;
    if (role == Qt::EditRole) {
        const QString name = value.toString().trimmed();
        if (name.isEmpty() || name == segment.name)
            return false;
        edit.name = name;
    } else if (role == ColourRole) {
        const std::uint32_t rgb = value.value<QColor>().rgb() & 0xFFFFFFu;
        if (rgb == segment.rgb)
            return false;
        edit.rgb = rgb;
    } else if (role == LockedRole) {
        if (value.toBool() == segment.locked)
            return false;
        edit.locked = value.toBool();
    } else if (role == ProtectedRole) {
        if (value.toBool() == segment.uncarvable)
            return false;
        edit.uncarvable = value.toBool();
    } else if (role == CodeRole) {
        const QStringList code = value.toStringList();
        const core::CodedConcept coded{code.value(0), code.value(1), code.value(2)};
        if (coded == segment.code)
            return false;
        edit.code = coded;
    } else {
        return false;
    }
    const auto applied = m_workspace.session()->apply(edit);
    if (!applied)
        m_workspace.fail(applied.error());
    return applied.has_value();
}

Qt::ItemFlags SegmentListModel::flags(const QModelIndex& index) const
{
    if (!index.isValid())
        return Qt::NoItemFlags;
    return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable | Qt::ItemNeverHasChildren;
}

} // namespace ui
