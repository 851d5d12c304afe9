// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/parts/SparedSegments.h"
#include "core/edits/kinds/parts/StrokeParameters.h"
#include "core/engine/EngineCommands.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace core {

using SculptKinds = EditKinds<DrillStroke, BrushStroke, PeelCut, ScissorsCut, LaserStroke>;

/// An edit that writes the coverage of a sculpt layer: by the greater value where it carves, by the
/// lesser where it restores. As with Edit, nobody who only hands one on needs more than this
/// header; visitSculpt() (SculptVisit.h) asks all kinds alike.
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
/// Whether what is seen decides where it cuts.
[[nodiscard]] bool startsOnSurface(const SculptEdit& edit);

/// The outline that was drawn for it by hand; null: there is none.
[[nodiscard]] const std::vector<glm::dvec2>* outlineOf(const SculptEdit& edit);

/// What an edit that carves spares: its own list. Null: it carves nothing, or restores.
[[nodiscard]] SparedSegments* sparedBy(Edit& edit);
[[nodiscard]] const SparedSegments* sparedBy(const Edit& edit);
/// Adds the segments that are protected to that (core/edits/engine/SparedSegments.h).
void spareProtected(Edit& edit, const Document& document);

[[nodiscard]] StrokeParameters parametersOf(const SculptEdit& edit);

/// The edit as @p revision makes it. Errors: InvalidField for what it has not.
[[nodiscard]] Result<SculptEdit> revised(SculptEdit edit, const ReviseStroke& revision);

/// Whether an edit writes a layer's coverage otherwise than by a cut, so that the cuts alone do not
/// make up what stands there.
[[nodiscard]] bool writesLayer(const Edit& edit, int layer);
/// The same of whatever layer.
[[nodiscard]] bool writesSomeLayer(const Edit& edit);

/// An edit in one go, as submitWhole() takes it.
struct WholeCut {
    EngineEdit edit;
    std::vector<EngineExtension> extensions;
};

/// What an edit cuts by itself, into an empty layer; what a restoring one gives back is cut too.
/// Errors: InvalidField.
[[nodiscard]] Result<WholeCut> cutAlone(
    const SculptEdit& edit, const Document& document, std::uint8_t layer);

} // namespace core
