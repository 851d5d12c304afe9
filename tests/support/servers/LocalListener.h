// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace test {

/// A port of this machine alone, which the system chooses, and who comes there.
class LocalListener {
public:
    LocalListener();
    LocalListener(const LocalListener&) = delete;
    LocalListener& operator=(const LocalListener&) = delete;
    ~LocalListener();

    /// 0: there is none.
    [[nodiscard]] int port() const { return m_port; }
    /// Waits for a moment. @return the socket of who came, for the caller to close; -1: nobody did
    [[nodiscard]] int accepted() const;

private:
    int m_socket;
    int m_port = 0;
};

} // namespace test
