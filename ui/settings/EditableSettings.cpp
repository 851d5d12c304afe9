// SPDX-License-Identifier: Apache-2.0
#include "ui/settings/EditableSettings.h"

#include "ui/base/StudyTexts.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

namespace ui {

namespace {

using Where = EditableSettings::Where;

struct EditableTexts {
    Q_DECLARE_TR_FUNCTIONS(ui::EditableSettings)
};

std::vector<int> visibleSegments(const core::Document& document)
{
    std::vector<int> labels;
    for (const core::Segment& segment : document.segments) {
        if (segment.visible)
            labels.push_back(segment.label);
    }
    std::sort(labels.begin(), labels.end());
    return labels;
}

std::vector<int> theSegment(const EditableSettings& settings, const core::Document& document)
{
    if (document.segment(settings.segment))
        return {settings.segment};
    return {};
}

QString whereText(const EditableSettings& settings, const core::Document& document)
{
    const core::Segment* segment = document.segment(settings.segment);
    const QString name = segment ? segment->name : EditableTexts::tr("a segment that is gone");
    switch (settings.where) {
    case Where::Anywhere:
        break;
    case Where::Inside:
        return EditableTexts::tr("inside %1").arg(name);
    case Where::Outside:
        return EditableTexts::tr("outside %1").arg(name);
    case Where::InsideVisible:
        return EditableTexts::tr("inside visible segments");
    case Where::OutsideVisible:
        return EditableTexts::tr("outside visible segments");
    }
    return {};
}

} // namespace

std::optional<core::EditableRange> editableRange(const EditableSettings& settings,
    const core::Document& document, const std::optional<EditableBox>& box)
{
    if (!settings.on)
        return std::nullopt;
    core::EditableRange range;
    if (settings.byValue) {
        range.lower = std::min(settings.lower, settings.upper);
        range.upper = std::max(settings.lower, settings.upper);
    }
    if (settings.boxed && box)
        range.box = box->box;
    switch (settings.where) {
    case Where::Anywhere:
        break;
    case Where::Inside:
        range.inside = theSegment(settings, document);
        break;
    case Where::Outside:
        range.outside = theSegment(settings, document);
        break;
    case Where::InsideVisible:
        range.inside = visibleSegments(document);
        break;
    case Where::OutsideVisible:
        range.outside = visibleSegments(document);
        break;
    }
    return range;
}

QString editableText(const EditableSettings& settings, const core::Document& document,
    const std::optional<EditableBox>& box)
{
    if (!settings.on)
        return {};
    QStringList parts;
    if (settings.byValue && !document.volumes.empty()) {
        const core::Volume& volume = document.volumes.front();
        const double span = volume.maximum - volume.minimum;
        parts += EditableTexts::tr("only %1 … %2")
                     .arg(valueText(std::min(settings.lower, settings.upper), {}, span).trimmed(),
                         valueText(std::max(settings.lower, settings.upper), volume.unit, span));
    }
    if (const QString where = whereText(settings, document); !where.isEmpty())
        parts += where;
    if (settings.boxed && box)
        parts += box->isClip ? EditableTexts::tr("in the clip box")
                             : EditableTexts::tr("in the box of growth");
    if (parts.isEmpty())
        return EditableTexts::tr("editable: all voxels");
    return EditableTexts::tr("editable: %1").arg(parts.join(QStringLiteral(", ")));
}

} // namespace ui
