// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <vector>

namespace core {

/// Work that has to take slices in their order, one at a time, while they come in any order: who
/// brings one takes the work on as far as slices are there, unless somebody is at it already.
class SliceChain {
public:
    /// @param work called for 0 … slices − 1, from any thread that calls what is below
    SliceChain(int slices, std::function<void(int k)> work);

    /// Slice @p k is there, and nobody changes it until isPast(k). Any thread.
    void sliceIsThere(int k);
    /// Takes the work to its end. @pre all slices are there
    void finish();
    /// Waits until slice @p k is done with. @pre somebody is in finish(), or has been
    void waitFor(int k) const;

private:
    void carryOn(); ///< m_mutex is held

    std::function<void(int k)> m_work;
    std::vector<std::atomic<bool>> m_there;
    std::mutex m_mutex;
    std::atomic<int> m_done = 0; ///< written under m_mutex
};

} // namespace core
