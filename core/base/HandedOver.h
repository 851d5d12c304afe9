// SPDX-License-Identifier: Apache-2.0
#pragma once

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define BURIN_UNDER_THREAD_SANITIZER
extern "C" void __tsan_acquire(void* address);
extern "C" void __tsan_release(void* address);
#endif
#endif

namespace core {

/// Tells the thread sanitizer (packaging/tsan.sh) that what a queued call captures was written
/// before another thread reads it. Qt's event loop guarantees that by locks that the sanitizer
/// cannot see. In other builds this class does nothing.
///
/// Use: the function that is passed to QMetaObject::invokeMethod() captures a HandedOver as its
/// last capture and calls takeOver() before anything else. Qt moves the function into memory of its
/// own, and the last move is the one that counts. A captured `this` needs another name, because the
/// implicit one would be read first.
class HandedOver {
public:
    HandedOver() = default;
#ifdef BURIN_UNDER_THREAD_SANITIZER
    HandedOver(const HandedOver&)
    {
        __tsan_release(&place);
    }
    HandedOver& operator=(const HandedOver&) = default;
    ~HandedOver() = default;
    void takeOver() const
    {
        __tsan_acquire(&place);
    }

private:
    static inline char place = 0; ///< one for all: calls order more than they would have to
#else
    void takeOver() const { }
#endif
};

} // namespace core
