// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/growth/GrowthCommands.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <optional>
#include <vector>

namespace ui {

class Workspace;

/// What a targeted shrink would take, while the pen is down (VoxelQuestions::foreseeCut()). The
/// engine tints it; here it is asked, one question at a time, and told in words. Nothing waits and
/// nothing changes.
class ShrinkForesight : public QObject {
    Q_OBJECT

public:
    explicit ShrinkForesight(Workspace& workspace, QObject* parent = nullptr);

    /// @param onlyHere only the sketched voxels are to go
    void begin(bool onlyHere);
    /// All that is sketched so far.
    void follow(const std::vector<glm::ivec3>& voxels);
    /// Takes the tint away.
    void end();

    /// "takes 12.4 mL", or why it will take nothing; empty while no sketch is followed.
    [[nodiscard]] QString words() const;
    /// Of the last answer; none: there was none yet.
    [[nodiscard]] std::optional<std::int64_t> voxels() const;
    /// The last answer is about all that is sketched.
    [[nodiscard]] bool upToDate() const { return m_foreseen && m_answered == m_wanted.size(); }

Q_SIGNALS:
    void changed();

private:
    void ask();
    /// @param foreseen none: it is being worked out
    void take(const core::Result<std::optional<core::ForeseenCut>>& foreseen);

    Workspace& m_workspace;
    bool m_on = false;
    bool m_onlyHere = false;
    bool m_asking = false;
    std::vector<glm::ivec3> m_wanted;
    std::size_t m_asked = 0; ///< voxels of the question that is out
    std::size_t m_answered = 0; ///< of the one that was answered last
    std::optional<core::ForeseenCut> m_foreseen; ///< its bricks are left out
    std::optional<core::Error> m_refused; ///< why the last one would take nothing
    QTimer m_again; ///< it is being worked out
    int m_sketch = 0; ///< number of the present one
};

} // namespace ui
