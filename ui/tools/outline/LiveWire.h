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

/// A wire that follows the edges of a slice from anchor to anchor (core/outline/CheapestWays.h).
/// Costs and paths are computed on a background thread, for the window of grey values at the first
/// anchor. Until a path is known the wire is straight there. Anchors may be set meanwhile; the
/// result does not depend on how fast the computation is. GUI thread.
class LiveWire : public QObject {
    Q_OBJECT

public:
    /// @param slice holds the values that the wire follows; must outlive this, and show the same
    /// slice while there are anchors
    LiveWire(Workspace& workspace, ReadSlice& slice, QObject* parent = nullptr);

    /// Removes all anchors.
    void drop();
    /// Sets an anchor at the pixel corner nearest to a place (LPS mm).
    void addAnchor(const glm::dvec3& placeLps);
    /// Removes the last anchor. @pre there is one
    void removeAnchor();
    /// The number of different places with anchors.
    [[nodiscard]] std::size_t anchorCount() const;
    /// Whether a click at a place would set the first or the last anchor again.
    [[nodiscard]] bool endsAt(const glm::dvec3& placeLps) const;

    /// Whether all paths between anchors are known, and those that start at the last anchor.
    [[nodiscard]] bool isKnown() const;
    /// The pixel corners of the wire from the first anchor to the last, LPS mm.
    [[nodiscard]] std::vector<glm::dvec3> wireLps() const;
    /// The pixel corners from the last anchor (not included) to the one nearest to a place; empty
    /// if there is no anchor.
    [[nodiscard]] std::vector<glm::dvec3> onwardsLps(const glm::dvec3& placeLps) const;
    /// The pixel corners from the last anchor back to the first, both not included. @pre there is
    /// an anchor
    [[nodiscard]] std::vector<glm::dvec3> closingLps() const;

Q_SIGNALS:
    void changed(); ///< another path is known
    void failed(); ///< a computation failed; the workspace has told the user why

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
    /// The known paths, from anchor to anchor: one less than anchors if all are known.
    std::vector<std::vector<glm::ivec2>> m_ways;
    core::WindowLevel m_window; ///< the window for which the costs are computed
    std::shared_ptr<const core::SideCosts> m_costs; ///< null: not known yet
    /// Paths from the anchor at the end of the known paths; null: not known yet.
    std::shared_ptr<const core::CheapestWays> m_onwards;
    core::Background m_background;
};

} // namespace ui
