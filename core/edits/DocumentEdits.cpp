// SPDX-License-Identifier: Apache-2.0
#include "core/edits/DocumentEdits.h"

#include "core/edits/EngineEdits.h"

#include <algorithm>
#include <utility>

namespace core {

namespace {

constexpr int lastLabel = 255;

Result<bool> add(const AddSegment& edit, Document& document)
{
    // Segments are never taken out of the list, so the greatest label is the last one given.
    int label = 1;
    for (const Segment& segment : document.segments)
        label = std::max(label, segment.label + 1);
    if (label > lastLabel)
        return failure(ErrorCode::InvalidField, QStringLiteral("addSegment"),
            QStringLiteral("a label plane holds at most %1 segments").arg(lastLabel));
    document.segments.push_back(
        {.label = std::uint8_t(label), .name = edit.name, .rgb = edit.rgb, .code = edit.code});
    return true;
}

Result<bool> change(const ChangeSegment& edit, Document& document)
{
    Segment* segment = document.segment(edit.segment);
    if (!segment)
        return failure(ErrorCode::UnknownSegment, QString::number(edit.segment));
    bool changed = false;
    const auto assign = [&changed](auto& target, const auto& value) {
        if (!value || target == *value)
            return;
        target = *value;
        changed = true;
    };
    assign(segment->name, edit.name);
    assign(segment->rgb, edit.rgb);
    assign(segment->code, edit.code);
    assign(segment->locked, edit.locked);
    return changed;
}

Result<bool> move(const MoveSegment& edit, Document& document)
{
    std::vector<Segment>& segments = document.segments;
    const auto from = std::find_if(segments.begin(), segments.end(),
        [&edit](const Segment& segment) { return segment.label == edit.segment; });
    if (from == segments.end())
        return failure(ErrorCode::UnknownSegment, QString::number(edit.segment));
    const auto to =
        segments.begin() + (std::min<std::ptrdiff_t>(edit.place, std::ssize(segments)) - 1);
    if (from < to)
        std::rotate(from, from + 1, to + 1);
    else
        std::rotate(to, from, from + 1);
    return from != to;
}

template <class T> Result<void> discardValue(const Result<T>& result)
{
    if (!result)
        return tl::unexpected(result.error());
    return {};
}

} // namespace

bool changesDocumentOnly(const Edit& edit)
{
    return std::holds_alternative<AddSegment>(edit) || std::holds_alternative<ChangeSegment>(edit)
        || std::holds_alternative<MoveSegment>(edit);
}

Result<bool> applyToDocument(const Edit& edit, Document& document)
{
    if (const auto* addSegment = std::get_if<AddSegment>(&edit))
        return add(*addSegment, document);
    if (const auto* changeSegment = std::get_if<ChangeSegment>(&edit))
        return change(*changeSegment, document);
    if (const auto* moveSegment = std::get_if<MoveSegment>(&edit))
        return move(*moveSegment, document);
    return false;
}

Result<void> checkAgainst(const Document& document, const Edit& edit)
{
    if (changesDocumentOnly(edit)) {
        Document copy = {.volumes = {}, .segments = document.segments, .layers = {}, .growths = {}};
        return discardValue(applyToDocument(edit, copy));
    }
    if (const auto* seed = std::get_if<SeedStroke>(&edit))
        return discardValue(seedPlacement(*seed, document));
    if (const auto* grow = std::get_if<GrowSteps>(&edit))
        return discardValue(growBurst(*grow, document));
    if (std::holds_alternative<RevertRows>(edit))
        return {}; // it reads the history, not the document
    return discardValue(drillCut(std::get<DrillStroke>(edit), document));
}

Document initialDocument(Volume volume)
{
    Document document;
    document.volumes.push_back(std::move(volume));
    document.layers.push_back({.id = 1, .name = QStringLiteral("Sculpt 1")});
    document.growths.push_back({.plane = 0, .generation = 0});
    return document;
}

} // namespace core
