// Threads that core lends to a body, so that no plugin makes one of its own.
#pragma once

namespace stylet {

/// Shares a loop out among threads. The tasks of one run should be of like size, and a few for each thread: 16 of 20 µs, not
/// 2 of 160 µs nor 3000 of 0.1 µs; to wake a thread that sleeps may cost 20 µs, so a loop of less than 100 µs is better not
/// shared. Let every task write what no other task reads or writes, and the result is the same, bit for bit, however many
/// threads there are.
class Workers {
public:
    Workers() = default;
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;
    virtual ~Workers() = default;

    /// How many threads may work at once, the caller counted; at least 1.
    [[nodiscard]] virtual int count() const = 0;

    /// Calls task(i) once for every i in [0, tasks), on whichever threads are free, in any order, and returns when all are done;
    /// the caller does its share. Nothing happens where tasks ≤ 0. Tasks must not throw. A call from within a task, or from a
    /// second thread meanwhile, is right too, but done by its own thread alone. Allocates nothing. Makes no system call, except
    /// to wake threads that sleep and to sleep itself where another thread is late with a task that it has begun.
    template <class Task>
    void each(int tasks, Task&& task) {
        auto call = [&task](int index) { task(index); };
        run(
            tasks, [](void* context, int index) { (*static_cast<decltype(call)*>(context))(index); }, &call);
    }

protected:
    using Call = void (*)(void* context, int index);

private:
    virtual void run(int tasks, Call call, void* context) noexcept = 0;
};

/// A plain loop.
class OneThread final : public Workers {
public:
    [[nodiscard]] int count() const override { return 1; }

private:
    void run(int tasks, Call call, void* context) noexcept override {
        for (int i = 0; i < tasks; ++i) call(context, i);
    }
};

/// For whoever lends no threads.
[[nodiscard]] inline Workers& one_thread() {
    static OneThread only;
    return only;
}

}    // namespace stylet
