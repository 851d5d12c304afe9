// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <vector>

namespace core {

/// Runs work that needs slices in their order, one at a time, although they arrive in any order.
/// The thread that brings a slice continues the work as far as slices are available, unless another
/// thread is doing so already.
class SliceChain {
public:
    /// @param work called for 0 … slices − 1, from any thread that calls what is below
    SliceChain(int slices, std::function<void(int k)> work);

    /// Slice @p k is available; it must not change until isPast(k). Any thread.
    void sliceIsThere(int k);
    /// Runs the work to its end. @pre all slices are available
    void finish();
    /// Blocks until slice @p k was processed. @pre some thread is in finish(), or has been
    void waitFor(int k) const;

private:
    void carryOn(); ///< m_mutex is held

    std::function<void(int k)> m_work;
    std::vector<std::atomic<bool>> m_there;
    std::mutex m_mutex;
    std::atomic<int> m_done = 0; ///< written under m_mutex
};

} // namespace core
