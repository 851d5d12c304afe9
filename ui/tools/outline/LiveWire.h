// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Background.h"
#include "core/outline/CheapestWays.h"
#include "core/volume/Volume.h"

#include <QObject>

#include <glm/glm.hpp>

#include <cstddef>
#include <memory>
#include <vector>

namespace ui {

class ReadSlice;
class Workspace;

/// A wire that follows edges of a slice from anchor to anchor (core/outline/CheapestWays.h). Costs
/// and ways are worked out on another thread, in the window of values in which the slice is shown
/// when the first anchor is set; until a way is known the wire runs straight there. Anchors may be
/// set meanwhile: what becomes of them does not depend on how fast that goes.
class LiveWire : public QObject {
    Q_OBJECT

public:
    /// @param slice in which it lies; must outlive this, and show the same slice while there are
    /// anchors
    LiveWire(Workspace& workspace, ReadSlice& slice, QObject* parent = nullptr);

    void drop();
    /// At the corner of pixels that is nearest to the place.
    void addAnchor(const glm::dvec3& placeLps);
    /// The last one. @pre there is one
    void removeAnchor();
    /// How many places are anchors.
    [[nodiscard]] std::size_t anchorCount() const;
    /// Whether a click there would set the first or the last anchor again.
    [[nodiscard]] bool endsAt(const glm::dvec3& placeLps) const;

    /// Whether the ways between anchors are known, and those from the last one onwards.
    [[nodiscard]] bool isKnown() const;
    /// From the first anchor to the last.
    [[nodiscard]] std::vector<glm::dvec3> wireLps() const;
    /// From the last anchor, which is left out, to the corner of pixels nearest to a place. Empty
    /// if there is no anchor.
    [[nodiscard]] std::vector<glm::dvec3> onwardsLps(const glm::dvec3& placeLps) const;
    /// From the last anchor back to the first, both left out. @pre there is an anchor
    [[nodiscard]] std::vector<glm::dvec3> closingLps() const;

Q_SIGNALS:
    void changed(); ///< a way became known
    void failed(); ///< one could not be found, as the workspace says

private:
    void proceed();
    void findCosts();
    void findWays();
    [[nodiscard]] std::vector<glm::ivec2> onwards(const glm::ivec2& corner) const;
    [[nodiscard]] std::vector<glm::dvec3> placesOf(std::vector<glm::ivec2>::const_iterator from,
        std::vector<glm::ivec2>::const_iterator to) const;

    Workspace& m_workspace;
    ReadSlice& m_slice;
    std::vector<glm::ivec2> m_anchors;
    /// The known ones, from anchor to anchor: one less than anchors if all are.
    std::vector<std::vector<glm::ivec2>> m_ways;
    core::WindowLevel m_window; ///< of the costs
    std::shared_ptr<const core::SideCosts> m_costs; ///< null: not known
    /// From the anchor at the end of the known ways; null: not known.
    std::shared_ptr<const core::CheapestWays> m_onwards;
    core::Background m_background;
};

} // namespace ui
