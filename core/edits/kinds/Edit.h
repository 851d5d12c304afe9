// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>

namespace core {

// Edits are plain data: what the user did, in the patient's millimetres and modality units, without
// pointers and without anything that must be looked up elsewhere. Recipe, session file and replay
// share this form. Numbers that decide voxels are rounded once by quantised() (EditQuantise.h).

struct AddBookmark;
struct AddLayer;
struct AddMeasurement;
struct AddSegment;
struct Annotate;
struct ApplyTemplate;
struct AttractSurface;
struct BarrierStroke;
struct BrushStroke;
struct ChangeInterval;
struct ChangeLayer;
struct ChangeMarks;
struct ChangePiece;
struct ChangeSegment;
struct ChunkToggle;
struct CleanSegment;
struct CombineSegments;
struct CopySegment;
struct CutPiece;
struct DivideSegment;
struct DrillStroke;
struct DropSurface;
struct EvolveContour;
struct FillBetweenSlices;
struct FillOutline;
struct FloodFill;
struct FollowMask;
struct GrowFromSeeds;
struct GrowSteps;
struct ImportMask;
struct InvertSegment;
struct LaserStroke;
struct LayerToSegment;
struct LaySurface;
struct MarkSurface;
struct MergeLayers;
struct MoveLayer;
struct MoveMeasurement;
struct MoveSegment;
struct PaintStroke;
struct PastePiece;
struct PeelCut;
struct PlaneScrape;
struct PlugLeak;
struct PointDrag;
struct RemoveBookmark;
struct RemoveLayer;
struct RemoveMeasurement;
struct RemovePiece;
struct RemoveSegment;
struct ReshapeSegment;
struct MirrorSegment;
struct ResumeGrowth;
struct RevertRows;
struct ReviseStroke;
struct ScissorsCut;
struct SeedStroke;
struct SegmentScissors;
struct SegmentSeen;
struct SegmentToLayer;
struct SendPiecesHome;
struct ShrinkAt;
struct ShrinkSteps;
struct SmoothSurface;
struct SpherePush;
struct SplitByCurve;
struct SplitIslands;
struct SplitSegment;
struct SurfaceBarrier;
struct ThresholdSegment;
struct WriteBack;

template <class... Es> struct EditKinds {
    static constexpr std::size_t count = sizeof...(Es);
};
/// All kinds of edits. Nothing that is stored depends on their order.
using AllEdits = EditKinds<AddSegment, ChangeSegment, MoveSegment, RemoveSegment, AddLayer,
    ChangeLayer, MoveLayer, AddBookmark, RemoveBookmark, SeedStroke, GrowSteps, DrillStroke,
    RevertRows, ReviseStroke, PaintStroke, BrushStroke, PeelCut, ScissorsCut, RemoveLayer,
    MergeLayers, LayerToSegment, SegmentToLayer, SegmentSeen, CutPiece, PastePiece, ChangePiece,
    SendPiecesHome, RemovePiece, LaserStroke, AddMeasurement, RemoveMeasurement, ShrinkSteps,
    ChangeInterval, ResumeGrowth, ShrinkAt, PlugLeak, BarrierStroke, GrowFromSeeds, ImportMask,
    LaySurface, DropSurface, FollowMask, MarkSurface, ChangeMarks, SpherePush, PlaneScrape,
    PointDrag, ApplyTemplate, SmoothSurface, AttractSurface, WriteBack, DivideSegment, ChunkToggle,
    SurfaceBarrier, InvertSegment, CleanSegment, CombineSegments, FillOutline, ReshapeSegment,
    FillBetweenSlices, FloodFill, ThresholdSegment, Annotate, MoveMeasurement, SegmentScissors,
    MirrorSegment, EvolveContour, SplitIslands, SplitSegment, CopySegment, SplitByCurve>;

template <class E, class... Es> constexpr std::size_t placeAmong(EditKinds<Es...>)
{
    std::size_t place = 0;
    static_cast<void>(((std::is_same_v<E, Es> || (++place, false)) || ...));
    return place;
}
/// The index of a kind in that list; AllEdits::count if it is none.
template <class E> inline constexpr std::size_t editPlace = placeAmong<E>(AllEdits());
template <class E>
concept isEdit = (editPlace<E> < AllEdits::count);

struct EditVariant; ///< a std::variant of all kinds (AnyEdit.h)

/// Any edit, as a value. Code that stores, copies or passes one on needs only this header. Code
/// that makes or reads a kind includes the header of that kind; code that handles all kinds
/// includes AnyEdit.h.
class Edit {
public:
    Edit(); ///< an AddSegment
    template <isEdit E>
    Edit(E edit)
        : Edit(editPlace<E>, &edit)
    {
    }
    Edit(const Edit& other);
    /// @p other is empty afterwards: it can only be assigned to or destroyed.
    Edit(Edit&& other) noexcept;
    Edit& operator=(const Edit& other);
    Edit& operator=(Edit&& other) noexcept;
    ~Edit();

    template <isEdit E> [[nodiscard]] bool is() const { return find(editPlace<E>) != nullptr; }
    /// Null if it is of another kind.
    template <isEdit E> [[nodiscard]] const E* as() const
    {
        return static_cast<const E*>(find(editPlace<E>));
    }
    template <isEdit E> [[nodiscard]] E* as()
    {
        return static_cast<E*>(const_cast<void*>(find(editPlace<E>)));
    }
    /// Throws std::bad_variant_access if it is of another kind.
    template <isEdit E> [[nodiscard]] const E& get() const
    {
        return *static_cast<const E*>(demand(editPlace<E>));
    }
    template <isEdit E> [[nodiscard]] E& get()
    {
        return *static_cast<E*>(const_cast<void*>(demand(editPlace<E>)));
    }

    /// Its index in AllEdits.
    [[nodiscard]] std::size_t kind() const;
    /// For visitEdit() (AnyEdit.h).
    [[nodiscard]] const EditVariant& any() const { return *m_edit; }
    [[nodiscard]] EditVariant& any() { return *m_edit; }

private:
    /// Moves from an edit of the kind at @p place.
    Edit(std::size_t place, void* edit);
    [[nodiscard]] const void* find(std::size_t place) const;
    [[nodiscard]] const void* demand(std::size_t place) const;

    std::unique_ptr<EditVariant> m_edit; ///< null only after it was moved from
};

} // namespace core
