// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include <vector>

class QPainter;

namespace core {
class EditSession;
}

namespace ui {

struct ViewContext;

/// The sketched seeds that no growth has taken up yet, to be drawn over the views.
class SeedMarks {
public:
    /// Seeds of the history's line up to its position, after the last growth.
    void update(const core::EditSession* session);
    [[nodiscard]] bool empty() const { return m_marks.empty(); }
    /// Dots in the segments' colours; on a slice those that lie in it.
    void paint(QPainter& painter, const ViewContext& view, const core::EditSession& session) const;

private:
    struct Mark {
        glm::dvec3 lps{0.0};
        int label = 0;
    };
    std::vector<Mark> m_marks;
};

} // namespace ui
