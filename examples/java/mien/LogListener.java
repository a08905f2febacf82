package mien;

/** Receives a session's messages on the calling thread; level: see Log. What it throws is ignored. */
@FunctionalInterface
public interface LogListener {
    void log(int level, String message);
}
