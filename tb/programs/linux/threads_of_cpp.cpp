// threads_of_cpp.cpp - std::thread, async, condition_variable, call_once and exceptions in threads
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <future>
#include <iostream>
#include <mutex>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

int main() {
    using namespace std::chrono_literals;
    std::atomic<int> sum{0};
    std::vector<std::thread> threads;
    for (int i = 1; i <= 5; ++i)
        threads.emplace_back([&sum, i] {
            std::this_thread::sleep_for(1ms * (6 - i));
            sum += i;
        });
    for (std::thread& thread : threads) thread.join();
    std::cout << "sum " << sum << '\n';

    std::vector<int> numbers(100000);
    std::iota(numbers.begin(), numbers.end(), 0);
    auto half = std::async(std::launch::async, [&] {
        return std::accumulate(numbers.begin(), numbers.begin() + 50000, 0LL);
    });
    const long long rest = std::accumulate(numbers.begin() + 50000, numbers.end(), 0LL);
    std::cout << "all " << half.get() + rest << '\n';

    auto fails = std::async(std::launch::async, [] { throw std::runtime_error{"as it should"}; });
    try {
        fails.get();
    } catch (const std::exception& e) {
        std::cout << "caught " << e.what() << '\n';
    }

    std::mutex mutex;
    std::condition_variable changed;
    bool ready = false;
    std::thread waker([&] {
        std::this_thread::sleep_for(5ms);
        const std::lock_guard<std::mutex> guard{mutex};
        ready = true;
        changed.notify_all();
    });
    std::unique_lock<std::mutex> guard{mutex};
    const bool early = changed.wait_for(guard, 1ms, [&] { return ready; });
    const bool later = changed.wait_for(guard, 100ms, [&] { return ready; });
    guard.unlock();
    waker.join();
    std::once_flag once;
    std::call_once(once, [] { std::cout << "once, "; });
    std::cout << early << ' ' << later << ", " << std::thread::hardware_concurrency()
              << " processors\n";
}
