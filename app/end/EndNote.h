// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFile>
#include <QString>

namespace app {

/// A note that a window is open and, after a crash, why it ended: a file in the user's state folder
/// that is locked while the window lives and removed when it is closed. A note that remains from a
/// window which was not closed is reported by the next window. It holds one word and nothing about
/// any study.
class EndNote {
public:
    static constexpr const char* outOfMemory = "memory";
    static constexpr const char* crashed = "crash";

    /// If the file cannot be made, there is no note.
    EndNote();
    ~EndNote();
    EndNote(const EndNote&) = delete;
    EndNote& operator=(const EndNote&) = delete;

    /// A sentence about how earlier windows ended that were not closed; reported once. Empty if all
    /// were closed.
    [[nodiscard]] static QString takeEarlier();

private:
    QFile m_file;
};

} // namespace app
