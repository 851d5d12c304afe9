// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/delta/Ending.h"
#include "core/document/Document.h"
#include "core/edits/kinds/IsOneOf.h"
#include "core/edits/kinds/SurfaceEdit.h"
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
#include "core/engine/EngineEdit.h"
#include "core/refine/tools/SurfaceStroke.h"
#include "core/session/surface/SurfaceAgreement.h"
#include "core/titles/RowTitle.h"

#include <memory>
#include <optional>
#include <vector>

namespace core {

/// Carries out an edit of the surface on the side thread, to which the surface belongs meanwhile.
/// The result depends only on mesh, mask and edit.
class SurfaceWork {
public:
    /// The result; if it has neither, nothing changed.
    struct Outcome {
        std::shared_ptr<const SurfaceStep> step; ///< the surface is already in the state after it
        std::optional<EngineEdit> voxels; ///< what the engine has to do
        std::optional<RowTitle> remark{}; ///< an addition to the row's name
    };

    /// What the work reads of the volume and the history.
    struct Read {
        VoxelBox greyBox; ///< greyBoxOf()
        std::vector<std::uint16_t> codes; ///< of that box, x fastest
        SurfacePast past; ///< for a WriteBack
    };
    SurfaceWork(SurfaceState& surface, SurfaceEdit edit, const Document& document, Read read);
    ~SurfaceWork();

    /// To be called first if the edit reads labels (readsLabels()).
    /// @param labels of the segment's plane, x fastest
    void setLabels(std::vector<std::uint8_t> labels) { m_labels = std::move(labels); }
    /// For a template this does everything and shows it; end() keeps it or takes it back. Errors:
    /// the edit cannot be carried out.
    Result<void> begin();
    /// @param pressures of each point (PenPressures); empty: the pen is pressed fully
    void add(const std::vector<glm::dvec3>& pointsLps, const std::vector<double>& pressures = {});
    [[nodiscard]] Result<Outcome> end(Ending ending);
    /// Ends the laying of a surface, the following of a mask, or what a template moves, as early as
    /// possible, with Cancelled; a stroke of the pen moves nothing any more. Any thread.
    void cancel() { m_progress.cancel(); }
    /// Marks it as failed after one of the functions above has thrown.
    void fail(const Error& error) { m_error = error; }

private:
    void settle();
    // One for each kind of edit of the surface:
    [[nodiscard]] Result<Outcome> carryOut(const LaySurface& edit, Ending ending);
    [[nodiscard]] Result<Outcome> carryOut(const DropSurface& edit, Ending ending);
    [[nodiscard]] Result<Outcome> carryOut(const FollowMask& edit, Ending ending);
    [[nodiscard]] Result<Outcome> carryOut(const ChangeMarks& edit, Ending ending);
    [[nodiscard]] Result<Outcome> carryOut(const WriteBack& edit, Ending ending);
    [[nodiscard]] Result<Outcome> carryOut(const SurfaceBarrier& edit, Ending ending);
    template <class Stroke>
    requires isOneOf<Stroke, MarkSurface, SpherePush, PlaneScrape, PointDrag, ApplyTemplate,
        SmoothSurface, AttractSurface>
    [[nodiscard]] Result<Outcome> carryOut(const Stroke& stroke, Ending ending);
    [[nodiscard]] Result<Outcome> layCrossings();
    [[nodiscard]] std::vector<VertexId> markedVertices(const ChangeMarks& edit) const;
    [[nodiscard]] Outcome stepOf(
        SimplexMeshDelta delta, std::optional<SurfaceStep::TargetChange> target = {});

    SurfaceState& m_surface;
    SurfaceEdit m_edit;
    Segment m_segment;
    std::bitset<256> m_overwritable;
    std::optional<EditableVoxels> m_editable;
    std::bitset<256> m_locked; ///< labels of the segment's plane
    Read m_read;
    std::vector<std::uint8_t> m_labels;
    std::unique_ptr<const GreyBox> m_grey;
    Progress m_progress; ///< only to be cancelled
    std::optional<Error> m_error; ///< why it failed
    std::unique_ptr<SurfaceStroke> m_stroke; ///< after m_grey, which it reads
    bool m_settled = false; ///< the stroke is settled, and that is shown
};

/// Whether an edit of the surface reads the labels of its segment's plane.
[[nodiscard]] bool readsLabels(const Edit& edit);
/// Whether an edit of the surface fits all of it to a mask, which may take long.
[[nodiscard]] bool fitsWholeSurface(const Edit& edit);
/// The voxels whose grey values it reads; none: it reads none.
[[nodiscard]] std::optional<VoxelBox> greyBoxOf(const Edit& edit, const SurfaceState& surface);

} // namespace core
