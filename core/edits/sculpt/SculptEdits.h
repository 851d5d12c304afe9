// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/parts/ProtectedSegments.h"
#include "core/edits/kinds/parts/StrokeParameters.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace core {

using SculptKinds = EditKinds<DrillStroke, BrushStroke, PeelCut, ScissorsCut, LaserStroke>;

/// Any edit that cuts into the coverage of a sculpt layer: it raises coverage when it carves and
/// lowers it when it restores. As with Edit, code that only passes one on needs just this header;
/// visitSculpt() (SculptVisit.h) handles all kinds.
class SculptEdit {
public:
    SculptEdit(); ///< a DrillStroke
    template <isEdit E>
    requires(placeAmong<E>(SculptKinds()) < SculptKinds::count) SculptEdit(E edit)
        : m_edit(std::move(edit))
    {
    }

    template <isEdit E> [[nodiscard]] bool is() const { return m_edit.is<E>(); }
    template <isEdit E> [[nodiscard]] const E* as() const { return m_edit.as<E>(); }
    template <isEdit E> [[nodiscard]] E* as() { return m_edit.as<E>(); }
    template <isEdit E> [[nodiscard]] const E& get() const { return m_edit.get<E>(); }

    [[nodiscard]] const Edit& plain() const { return m_edit; }

private:
    Edit m_edit;
};

[[nodiscard]] std::optional<SculptEdit> sculptEdit(const Edit& edit);
[[nodiscard]] bool isSculptEdit(const Edit& edit);
[[nodiscard]] int layerOf(const SculptEdit& edit);
[[nodiscard]] bool restores(const SculptEdit& edit);
/// Whether the visible surface decides where it cuts.
[[nodiscard]] bool startsOnSurface(const SculptEdit& edit);

/// Whether a mask is pressed into the volume by a pen: its depth is that at full pressure.
[[nodiscard]] bool isPressed(const SculptEdit& edit);

/// The drawn curve under which an edit cuts, in millimetres. Null: it has none, but a brush or a
/// round or square mask.
[[nodiscard]] const std::vector<glm::dvec2>* outlineOf(const SculptEdit& edit);

/// The list of segments that a carving edit protects. Null: the edit carves nothing, or restores.
[[nodiscard]] ProtectedSegments* protectedSegmentsOf(Edit& edit);
[[nodiscard]] const ProtectedSegments* protectedSegmentsOf(const Edit& edit);
/// Adds the segments that are protected to that list (core/edits/engine/SegmentProtection.h).
void addProtected(Edit& edit, const Document& document);

[[nodiscard]] StrokeParameters parametersOf(const SculptEdit& edit);

/// The edit after a revision. Errors: InvalidField for a parameter that it does not have.
[[nodiscard]] Result<SculptEdit> revised(SculptEdit edit, const ReviseStroke& revision);

/// Whether an edit writes the coverage of a layer in another way than by a cut, so that cuts alone
/// do not give its content. A kind that names a layer does not compile until this is known of it.
[[nodiscard]] bool writesLayer(const Edit& edit, int layer);
/// The same for any layer.
[[nodiscard]] bool writesSomeLayer(const Edit& edit);

} // namespace core
