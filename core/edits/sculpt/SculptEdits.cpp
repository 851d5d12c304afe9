// SPDX-License-Identifier: Apache-2.0
#include "core/edits/sculpt/SculptEdits.h"

#include "core/edits/engine/SegmentProtection.h"
#include "core/edits/kinds/AnyEdit.h"
#include "core/edits/kinds/IsOneOf.h"
#include "core/edits/kinds/sculpt/ToolMasks.h"
#include "core/edits/sculpt/SculptVisit.h"

#include <type_traits>
#include <utility>

namespace core {

namespace {

template <class Visitor> void visitSize(Visitor& visit, ToolMask& mask)
{
    using Kind = ToolMask::Kind;
    if (mask.polygonMm) {
        visit.outline(*mask.polygonMm, glm::dvec2(0.0));
    } else if (mask.kind == Kind::Circle) {
        visit.radius(mask.radiusMm);
    } else if (mask.kind == Kind::Square) {
        visit.side(mask.widthMm);
    } else {
        visit.width(mask.widthMm);
        visit.height(mask.heightMm);
    }
}

template <class Visitor> void visitOutline(Visitor& visit, std::vector<glm::dvec2>& outline)
{
    glm::dvec2 low(outline.empty() ? glm::dvec2(0.0) : outline.front());
    glm::dvec2 high = low;
    for (const glm::dvec2& point : outline) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    visit.outline(outline, (low + high) / 2.0);
}

/// Shows the layer of a cut, and what else of it can be revised, to a visitor: layer(), radius(),
/// side(), width(), height(), outline() with what stays in place, depth(), softness(),
/// throughGaps().
template <class Visitor, class Pressed> void visitPressed(Visitor& visit, Pressed& stroke)
{
    visit.layer(stroke.layer);
    visitSize(visit, stroke.mask);
    visit.depth(stroke.depthMm);
    visit.softness(stroke.mask.softnessMm);
    visit.throughGaps(stroke.throughGaps);
}

template <class Visitor> void visitParameters(Visitor& visit, DrillStroke& stroke)
{
    visitPressed(visit, stroke);
}

template <class Visitor> void visitParameters(Visitor& visit, LaserStroke& stroke)
{
    visitPressed(visit, stroke);
}

template <class Visitor> void visitParameters(Visitor& visit, BrushStroke& stroke)
{
    visit.layer(stroke.layer);
    visit.radius(stroke.path.radiusMm);
}

template <class Visitor> void visitParameters(Visitor& visit, PeelCut& peel)
{
    visit.layer(peel.layer);
    visitOutline(visit, peel.polygonMm);
    visit.depth(peel.depthMm);
    visit.throughGaps(peel.throughGaps);
}

template <class Visitor> void visitParameters(Visitor& visit, ScissorsCut& cut)
{
    visit.layer(cut.layer);
    visitOutline(visit, cut.polygonMm);
    if (cut.depthMm)
        visit.depth(*cut.depthMm);
}

template <class E>
concept hasLayer = requires
{
    &E::layer;
};

/// Whether a kind of edit names a layer. One that does is listed in what follows, or it does not
/// compile: nobody could know whether cuts alone give a layer's content.
template <class E>
concept namesLayer =
    hasLayer<E> || std::is_same_v<decltype(E::into), int> || std::is_same_v<decltype(E::from), int>;

/// Whether an edit writes a layer's coverage otherwise than by a cut.
struct WritesLayer {
    std::optional<int> layer; ///< id; none: whatever layer

    [[nodiscard]] bool isThat(int id) const { return !layer || id == *layer; }

    bool operator()(const SegmentToLayer& segment) const { return isThat(segment.layer); }
    bool operator()(const MergeLayers& merge) const
    {
        return isThat(merge.from) || isThat(merge.into);
    }
    bool operator()(const RemoveLayer& remove) const { return isThat(remove.layer); }
    /// They read coverage, or change what the list says of a layer. A revision is counted with the
    /// cut that it changes.
    template <class E>
    requires isOneOf<E, ChangeLayer, MoveLayer, LayerToSegment, CutPiece, ReviseStroke>
    bool operator()(const E&) const { return false; }
    template <class E>
    requires(placeAmong<E>(SculptKinds()) < SculptKinds::count) bool operator()(const E&) const
    {
        return false;
    }
    template <class E>
    requires(!namesLayer<E>) bool operator()(const E&) const { return false; }
};

struct StartsOnSurface {
    bool operator()(const ScissorsCut& cut) const { return cut.depthMm || cut.firstLayerOnly; }
    bool operator()(const BrushStroke&) const { return false; }
    template <class E>
    requires isOneOf<E, DrillStroke, LaserStroke, PeelCut>
    bool operator()(const E&) const { return true; }
};

struct IsPressed {
    template <class E>
    requires isOneOf<E, DrillStroke, LaserStroke>
    bool operator()(const E&) const { return true; }
    template <class E>
    requires isOneOf<E, BrushStroke, PeelCut, ScissorsCut>
    bool operator()(const E&) const { return false; }
};

struct ParameterReader {
    void layer(int value) { read.layer = value; }
    void radius(double value) { read.radiusMm = value; }
    void side(double value) { read.sideMm = value; }
    void width(double value) { read.widthMm = value; }
    void height(double value) { read.heightMm = value; }
    void outline(const std::vector<glm::dvec2>&, const glm::dvec2&) { read.factor = 1.0; }
    void depth(double value) { read.depthMm = value; }
    void softness(double value) { read.softnessMm = value; }
    void throughGaps(bool value) { read.throughGaps = value; }
    StrokeParameters read;
};

/// Takes what it uses out of the revision.
struct ParameterWriter {
    void layer(int& value) { value = std::exchange(revision.layer, {}).value_or(value); }
    void radius(double& value) { value = std::exchange(revision.radiusMm, {}).value_or(value); }
    void side(double& value) { value = std::exchange(revision.sideMm, {}).value_or(value); }
    void width(double& value) { value = std::exchange(revision.widthMm, {}).value_or(value); }
    void height(double& value) { value = std::exchange(revision.heightMm, {}).value_or(value); }
    void outline(std::vector<glm::dvec2>& points, const glm::dvec2& middle)
    {
        const double factor = std::exchange(revision.factor, {}).value_or(1.0);
        if (factor == 1.0)
            return;
        for (glm::dvec2& point : points)
            point = middle + (point - middle) * factor;
    }
    void depth(double& value) { value = std::exchange(revision.depthMm, {}).value_or(value); }
    void softness(double& value) { value = std::exchange(revision.softnessMm, {}).value_or(value); }
    void throughGaps(bool& value)
    {
        value = std::exchange(revision.throughGaps, {}).value_or(value);
    }
    ReviseStroke revision;
};

} // namespace

bool writesLayer(const Edit& edit, int layer)
{
    return visitEdit(WritesLayer{.layer = layer}, edit);
}

bool writesSomeLayer(const Edit& edit)
{
    return visitEdit(WritesLayer{.layer = std::nullopt}, edit);
}

SculptEdit::SculptEdit()
    : m_edit(DrillStroke())
{
}

std::optional<SculptEdit> sculptEdit(const Edit& edit)
{
    std::optional<SculptEdit> found;
    visitAmong([&found](const auto& known) { found = SculptEdit(known); }, edit, SculptKinds());
    return found;
}

bool isSculptEdit(const Edit& edit)
{
    return isAmong(edit, SculptKinds());
}

int layerOf(const SculptEdit& edit)
{
    return visitSculpt([](const auto& known) { return known.layer; }, edit);
}

bool restores(const SculptEdit& edit)
{
    return visitSculpt([](const auto& known) { return known.restore; }, edit);
}

bool startsOnSurface(const SculptEdit& edit)
{
    return visitSculpt(StartsOnSurface(), edit);
}

bool isPressed(const SculptEdit& edit)
{
    return visitSculpt(IsPressed(), edit);
}

const std::vector<glm::dvec2>* outlineOf(const SculptEdit& edit)
{
    return visitSculpt(
        [](const auto& known) -> const std::vector<glm::dvec2>* {
            using E = std::decay_t<decltype(known)>;
            if constexpr (std::is_same_v<E, BrushStroke>)
                return nullptr;
            else if constexpr (isOneOf<E, DrillStroke, LaserStroke>)
                return known.mask.polygonMm ? &*known.mask.polygonMm : nullptr;
            else
                return &known.polygonMm;
        },
        edit);
}

const ProtectedSegments* protectedSegmentsOf(const Edit& edit)
{
    const ProtectedSegments* protectedSegments = nullptr;
    const auto look = [&protectedSegments](const auto& cut) {
        if (!cut.restore)
            protectedSegments = &cut.protectedSegments;
    };
    visitAmong(look, edit, SculptKinds());
    return protectedSegments;
}

ProtectedSegments* protectedSegmentsOf(Edit& edit)
{
    return const_cast<ProtectedSegments*>(protectedSegmentsOf(std::as_const(edit)));
}

void addProtected(Edit& edit, const Document& document)
{
    if (ProtectedSegments* protectedSegments = protectedSegmentsOf(edit))
        addProtected(*protectedSegments, document);
}

StrokeParameters parametersOf(const SculptEdit& edit)
{
    SculptEdit copy = edit;
    ParameterReader reader;
    visitSculpt([&reader](auto& known) { visitParameters(reader, known); }, copy);
    return reader.read;
}

Result<SculptEdit> revised(SculptEdit edit, const ReviseStroke& revision)
{
    ParameterWriter writer{revision};
    visitSculpt([&writer](auto& known) { visitParameters(writer, known); }, edit);
    const ReviseStroke& left = writer.revision;
    const char* missing = left.radiusMm ? "radiusMm"
        : left.sideMm                   ? "sideMm"
        : left.widthMm                  ? "widthMm"
        : left.heightMm                 ? "heightMm"
        : left.factor                   ? "factor"
        : left.depthMm                  ? "depthMm"
        : left.softnessMm               ? "softnessMm"
        : left.throughGaps              ? "throughGaps"
                                        : nullptr;
    if (missing)
        return failure(ErrorCode::InvalidField,
            QStringLiteral("reviseStroke.") + QLatin1String(missing),
            Clause::saying("the cut of row %1 has none", revision.row));
    return edit;
}

} // namespace core
