package mien;

import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;

/** Where native code calls back: `user` is a number that stands for a receiver. Nothing may throw from here. */
final class Callbacks {
    private static final Map<Long, Object> RECEIVERS = new ConcurrentHashMap<>();
    private static final AtomicLong NEXT = new AtomicLong(1);

    private Callbacks() {}

    static long remember(Object receiver) {
        long user = NEXT.getAndIncrement();
        RECEIVERS.put(user, receiver);
        return user;
    }

    static void forget(long user) { RECEIVERS.remove(user); }

    static int progress(long user, int stage, double fraction) {
        Object receiver = RECEIVERS.get(user);
        return receiver instanceof Call ? ((Call) receiver).report(stage, fraction) : 1;
    }

    static void log(long user, int level, long message) {
        try {
            Object receiver = RECEIVERS.get(user);
            if (receiver instanceof LogListener) ((LogListener) receiver).log(level, Call.text(message));
        } catch (Throwable ignored) {
            // A log must not stop a call, and nothing may unwind through native frames.
        }
    }
}
